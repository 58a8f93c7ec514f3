#pragma once

/// Free position for a thing that is added to a live world.

#include <vector>

#include "live/world/world_state.h"

namespace thenar {

/// Balls around the surfaces of a hand in its reference posture, or around a body, own frame [m].
using BoundingBalls = std::vector<Ball>;

/// Computes a position for a new thing at which its box overlaps no other box: the origin if that
/// is free, else along x, 20 mm beside all other things [m] (3). Boxes enclose the balls of things,
/// so they are conservative.
/// @param balls  balls of the new thing in its frame
/// @param R      rotation of the new thing (3, 3)
[[nodiscard]] Eigen::Vector3d free_position(const WorldState& state, const BoundingBalls& balls,
                                            const Eigen::Matrix3d& R = Eigen::Matrix3d::Identity());

}  // namespace thenar
