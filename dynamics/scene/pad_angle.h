#pragma once

/// Angle between a finger pad and its contact force.

#include <vector>

#include "dynamics/scene/measure_run.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// Contact of a pad at one instant.
struct PadState {
  double t = 0;      // time [s]
  double force = 0;  // magnitude of the sum of the normal forces [N]
  double angle = 0;  // between the pad's normal and that sum, which acts on the other body [rad]
};

/// Computes the angle of a pad at all instants with a contact force: 0 where the middle of the pad
/// presses on the other body, 90 deg where its side does.
/// @param body     index of the body with the pad
/// @param other    index of the body that it presses on
/// @param outward  unit normal of the pad, frame of `body` (3)
/// @throws InputError if run and measures differ in their number of instants, or a body does not
///         exist.
[[nodiscard]] std::vector<PadState> pad_angles(const SceneRun& run, const RunMeasures& measures,
                                               int body, int other, const Eigen::Vector3d& outward);

}  // namespace thenar
