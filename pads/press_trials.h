#pragma once

/// Finite-element presses to which reduced laws of a pad are fitted.

#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "geometry/collision/curvature.h"
#include "pads/pad_model.h"
#include "solvers/status.h"

namespace thenar {

/// Straight press of an object on a pad to several depths.
struct PressTrial {
  std::string name;  // "ball of 5 mm"
  RigidObject object;
  Pose<double> X_PO;                // pose of the object before it touches
  Eigen::Vector3d along{0, 0, -1};  // direction of motion in the pad's frame, unit (3)
  std::vector<double> depths;       // depths beyond the first touch, rising [m]
};

/// One finite-element press, with the quantities that laws predict.
struct MeasuredPress {
  std::string trial;
  std::shared_ptr<const Shape> object;
  Pose<double> X_PO;       // pose of the object in the pad's frame
  RelativeCurvatures gap;  // curvatures of the undeformed gap where the surfaces overlap most
  double depth = 0;        // largest overlap of the undeformed surfaces [m]
  double force = 0;        // normal force [N]
  double area = 0;         // area of the patch [m^2]
  double aspect = 1;       // ratio of semi-axes by second moments of the pressure, >= 1 [1]
  double arm = 0;  // mean distance of the pressure from its centre: torsion per normal force
                   // for a friction of 1 [m]
  double force_error = 0;  // relative error that the elements estimate [1]
  double penetration = 0;  // depth of the deepest point of a face in the object [m]
  double shear = 0;        // tangential stiffness that sticking adds, mean over directions [N/m]
};

/// Presses to which laws are fitted, and others that measure their errors.
struct LawTrials {
  std::vector<PressTrial> fit, check;
};

/// Returns the depths of the standard trials of a pad: 1, 2, 3 and 4 elevenths of the thickness of
/// the soft tissue over the middle of the bone, rounded to the nanometre [m]. The default pad, 5.5
/// mm thick, is pressed to 0.5, 1, 1.5 and 2 mm.
/// @throws InputError as PadChart.
[[nodiscard]] std::vector<double> trial_depths(const PadShape& shape);

/// Returns the standard trials. Fit: a plane, straight and inclined by 30 degrees, balls of 5 and
/// 20 mm radius, and a cylinder of 8 mm radius across the finger, each to `depths`. Check: a plane
/// at 15 degrees, a ball of 10 mm and a cylinder of 8 mm along the finger, to depths in between.
/// The objects have the same size for any pad: that of everyday objects.
/// @throws InputError unless depths are positive and rise.
[[nodiscard]] LawTrials standard_trials(const PadShape& shape, const std::vector<double>& depths);

/// Presses that were solved, and descriptions of those that failed.
struct [[nodiscard]] MeasuredPresses {
  std::vector<MeasuredPress> presses;
  std::vector<std::string> failures;
  Status status = Status::kSolved;  // kStopped: the remaining presses were not made
};
/// Presses the pad in all trials. After a press that fails, the deeper presses of its trial are
/// skipped. A press with too few nodes for a patch is a failure, too, but the deeper presses
/// follow. A stop returns the presses done before it.
/// @param progress  report after each press; a stop ends the present press
/// @throws InputError as PadPress, or if a trial's object begins inside the pad or passes it by.
MeasuredPresses measure_presses(const PadModel& model, const std::vector<PressTrial>& trials,
                                PadPressOptions options, const Progress& progress = {});

}  // namespace thenar
