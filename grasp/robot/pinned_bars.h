#pragma once

/// Bars of four-bar linkages in robots whose files open the loop.

#include <utility>
#include <vector>

#include "grasp/robot/rigid_bodies.h"

namespace thenar {

/// Finds bars that move as if a pin held them to a finger: files without loops (URDF) let each bar
/// of a linkage follow the motor by itself (`mimic`), so that the inner knuckle of a gripper ends
/// its own chain as a finger does. A bar is a rigid body on a hinge that carries no other; the
/// finger hangs by two joints or more on the body on which the bar hangs; the same motor moves
/// both; and an axis passes near both, within a quarter of their diagonals, that lies still in
/// both within 0.1 mm at the ends and in the middle of the motor's range, over which one turns
/// against the other.
/// @returns the body of each bar, and that of its finger
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> pinned_bars(
    const RobotSpec& robot, const RigidBodies& bodies);

}  // namespace thenar
