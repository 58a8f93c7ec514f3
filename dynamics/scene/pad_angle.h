#pragma once

/// Direction of a finger pad while it presses on something.

#include <vector>

#include "dynamics/scene/measure_run.h"
#include "dynamics/stepping/scene_run.h"

namespace thenar {

/// A pad at an instant at which its body touches.
struct PadState {
  double t;      // [s]
  double force;  // with which both press on each other: length of the sum of normal forces [N]
  double angle;  // between the pad's normal and that sum, towards the other body [rad]
};

/// The pad of one body against another at all instants at which they press on each other: 0 where
/// it presses with its middle, 90 deg where with its side.
/// @param body, other  bodies of the scene
/// @param outward      normal of the pad, unit, frame of `body` (3)
/// @throws InputError if run and measures do not belong together, or a body is not there.
[[nodiscard]] std::vector<PadState> pad_angles(const SceneRun& run, const RunMeasures& measures,
                                               int body, int other, const Eigen::Vector3d& outward);

}  // namespace thenar
