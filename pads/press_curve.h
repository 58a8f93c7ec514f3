#pragma once

/// A pad pressed load after load on one mesh, together with neighbours that differ a little.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "pads/pad_model.h"

namespace thenar {

/// One load of a press.
struct PressLoad {
  std::optional<double> force;  // of the object along its direction [N]; or else
  double indentation = 0;       // from the first touch [m]
  double time = 0;              // since the load before [s]; 0: at once, infinity: relaxed
};

/// An object that presses on a pad along one direction.
struct PressCourse {
  RigidObject object;
  Pose<double> X_PO;                // anywhere outside, on its way
  Eigen::Vector3d along{0, 0, -1};  // its direction, unit, in the pad's frame (3)
  std::vector<PressLoad> loads;     // in their order in time
};

/// A pad under one load.
struct PressPoint {
  double indentation = 0;  // [m]
  double force = 0;        // [N]
  double area = 0;         // contact_area() [m^2]
};

/// Result of press_curves().
struct [[nodiscard]] PressCurves {
  Status status = Status::kSolved;              // kStopped: asked to; otherwise how a step failed
  std::string message;                          // "at 3 N: too many iterations"
  std::vector<std::vector<PressPoint>> points;  // (pads, loads)
  int iterations = 0;                           // of all pads
};

/// Presses the first pad load by load, steps cut in halves where they fail, and after each step the
/// others from its answer: pads whose constants or lengths differ by little need an iteration or
/// two. Meshes are those of `cells`, without refinement, so that answers are smooth in the pads'
/// constants. A pad that holds a history (relaxation, friction) keeps its own.
/// @param pads  with the same cells, layers, element and number of tissues; at least one
/// @throws InputError if they have not, or loads or the course make no sense.
PressCurves press_curves(const std::vector<PadModel>& pads, const PressCourse& course,
                         const Progress& progress = {});

}  // namespace thenar
