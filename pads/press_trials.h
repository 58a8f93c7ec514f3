#pragma once

/// Presses of finite elements that reduced laws of a pad are fitted to.

#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "geometry/collision/curvature.h"
#include "pads/pad_model.h"
#include "solvers/status.h"

namespace thenar {

/// An object that is pressed on a pad, straight, to several depths.
struct PressTrial {
  std::string name;  // "ball of 5 mm"
  RigidObject object;
  Pose<double> X_PO;                // before it touches
  Eigen::Vector3d along{0, 0, -1};  // of the motion, in the pad's frame, unit (3)
  std::vector<double> depths;       // beyond the first touch of an element, rising [m]
};

/// One press of finite elements, as laws see it.
struct MeasuredPress {
  std::string trial;
  std::shared_ptr<const Shape> object;
  Pose<double> X_PO;
  RelativeCurvatures gap;  // of the undeformed surfaces where they overlap most
  double depth = 0;        // their deepest overlap [m]
  double force = 0;        // normal [N]
  double area = 0;         // [m^2]
  double aspect = 1;       // ratio of semi-axes, by second moments of the pressure, >= 1 [1]
  double arm = 0;          // mean distance of the pressure from its centre: torsion for a friction
                           // of 1 [m]
  double force_error = 0;  // estimate of the elements [1]
  double penetration = 0;  // deepest point of the object within a face of the elements [m]
  double shear = 0;  // force by a way of the object across the press that sticking adds, in the
                     // mean over the ways [N/m]
};

/// Presses that laws are fitted to, and others to measure their errors.
struct LawTrials {
  std::vector<PressTrial> fit, check;
};

/// Depths to which laws of a pad are pressed: 1, 2, 3 and 4 elevenths of the soft tissue over the
/// middle of the bone, to the nanometre. The default pad, with 5.5 mm of it, is pressed to 0.5, 1,
/// 1.5 and 2 mm. [m]
/// @throws InputError as PadChart.
[[nodiscard]] std::vector<double> trial_depths(const PadShape& shape);

/// Fit: a plane, straight and inclined by 30 degrees, balls of 5 and 20 mm, a cylinder of 8 mm
/// across, each to `depths`. Check: a plane at 15 degrees, a ball of 10 mm, a cylinder of 8 mm
/// along the finger, at depths between them. Objects are as large for any pad: they are those that
/// hands meet.
/// @throws InputError unless depths are positive and rise.
[[nodiscard]] LawTrials standard_trials(const PadShape& shape, const std::vector<double>& depths);

/// Presses, of which those that the elements could not solve are left out and named.
struct [[nodiscard]] MeasuredPresses {
  std::vector<MeasuredPress> presses;
  std::vector<std::string> failures;
  Status status = Status::kSolved;  // kStopped: the remaining presses were not made
};
/// Presses the pad in all trials. After a press that is not solved, the deeper presses of its trial
/// are left out; a press with too few nodes for a patch is a failure, too, but deeper presses go
/// on. A stop returns the presses that were done before it.
/// @param progress  reports press by press; a stop ends the present one
/// @throws InputError as PadPress, or if a trial's object begins inside the pad or passes it by.
MeasuredPresses measure_presses(const PadModel& model, const std::vector<PressTrial>& trials,
                                PadPressOptions options, const Progress& progress = {});

}  // namespace thenar
