#pragma once

/// Where a thing that is added to a live world stands in nothing's way.

#include <vector>

#include "live/world/world_state.h"

namespace thenar {

/// Balls about the surfaces of a hand in reference posture, or about a body, in its own frame.
using OwnBalls = std::vector<Ball>;

/// How far a thing moves along x from the origin, so that the box about it meets that of no other
/// thing: 0 where it stands free there, else to 20 mm beside all others [m]. Boxes hold the balls
/// of things, so that they are a little too large.
/// @param R  its rotation (3, 3)
[[nodiscard]] Eigen::Vector3d free_place(const WorldState& state, const OwnBalls& balls,
                                         const Eigen::Matrix3d& R = Eigen::Matrix3d::Identity());

}  // namespace thenar
