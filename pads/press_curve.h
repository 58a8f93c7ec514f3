#pragma once

/// Press of a pad to several loads on one mesh, with pads of slightly different constants.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "pads/pad_model.h"

namespace thenar {

/// One load of a press.
struct PressLoad {
  std::optional<double> force;  // force of the object along its direction [N]; none: indentation
  double indentation = 0;       // depth from the first touch [m]
  double time = 0;              // time since the last load [s]; 0: instant, infinity: relaxed
};

/// Course of an object that presses on a pad along one direction.
struct PressCourse {
  RigidObject object;
  Pose<double> X_PO;                // initial pose, outside the pad, from which it meets the pad
  Eigen::Vector3d along{0, 0, -1};  // direction of motion in the pad's frame, unit (3)
  std::vector<PressLoad> loads;     // loads in the order of time
};

/// A pad under one load.
struct PressPoint {
  double indentation = 0;  // [m]
  double force = 0;        // [N]
  double area = 0;         // area of the patch, contact_area() [m^2]
};

/// Result of press_curves().
struct [[nodiscard]] PressCurves {
  Status status = Status::kSolved;              // kStopped by the caller; kStalled: a step failed
  std::string message;                          // "at 3 N: too many iterations"
  std::vector<std::vector<PressPoint>> points;  // (pads, loads)
  int iterations = 0;                           // iterations of all pads
};

/// Presses the first pad load by load, halving steps that fail. After each step the other pads
/// start from its solution: pads with slightly different constants or lengths need one or two
/// iterations. The meshes have `cells` cells and are not refined, so that results are smooth
/// functions of the pads' constants. Each pad keeps its own history of relaxation and friction.
/// @param pads  pads with the same cells, layers, element and number of tissues; at least one
/// @throws InputError if they differ in these, or loads or the course make no sense.
PressCurves press_curves(const std::vector<PadModel>& pads, const PressCourse& course,
                         const Progress& progress = {});

}  // namespace thenar
