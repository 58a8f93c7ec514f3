#pragma once

/// Free place for a thing that is added to a live world.

#include <vector>

#include "live/world/world_state.h"

namespace thenar {

/// Balls about the surfaces of a hand in reference posture, or about a body, in its own frame.
using OwnBalls = std::vector<Ball>;

/// Computes the shift along x from the origin at which the box about a thing meets that of no other
/// thing: 0 if the origin is free, else to 20 mm beside all others [m]. Boxes hold the balls of
/// things, so that they are a little too large.
/// @param R  rotation of the thing (3, 3)
[[nodiscard]] Eigen::Vector3d free_place(const WorldState& state, const OwnBalls& balls,
                                         const Eigen::Matrix3d& R = Eigen::Matrix3d::Identity());

}  // namespace thenar
