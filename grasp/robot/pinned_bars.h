#pragma once

/// Bars of four-bar linkages in robots whose files open the loop.

#include <utility>
#include <vector>

#include "grasp/robot/rigid_bodies.h"

namespace thenar {

/// Finds bars that move as if a pin connected them to a finger: in files without loops (URDF) each
/// bar of a linkage follows the motor separately (`mimic`), so that the inner knuckle of a gripper
/// ends its own chain like a finger. A bar is a rigid body on a hinge that carries no other body;
/// the finger is connected by two joints or more to the body that carries the bar; the same motor
/// moves both; and an axis passes near both, within 1/4 of their diagonals, that is at rest in both
/// within 0.1 mm at the ends and in the middle of the motor's range, over which one rotates
/// relative to the other.
/// @returns the body of each bar, and the body of its finger
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> pinned_bars(
    const RobotSpec& robot, const RigidBodies& bodies);

}  // namespace thenar
