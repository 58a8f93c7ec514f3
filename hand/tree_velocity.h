#pragma once

/// Velocities of links and hinges while one joint coordinate moves.

#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"

namespace thenar::internal {

/// Velocity of a rigid body.
struct BodyTwist {
  Eigen::Vector3d v{0, 0, 0};  // velocity of its point at the world's origin [m/s] (3)
  Eigen::Vector3d w{0, 0, 0};  // angular velocity [rad/s] (3)
  [[nodiscard]] Eigen::Vector3d velocity_at(const Eigen::Vector3d& p) const {
    return v + w.cross(p);
  }
};

/// Velocities of all links, and of the hinges they carry.
struct TreeVelocity {
  std::vector<BodyTwist> link;               // twists of the base, then of all links
  std::vector<Eigen::Vector3d> axis, point;  // rates of the hinges' directions and points
  [[nodiscard]] const BodyTwist& body(int link_or_base) const {
    const int place = link_or_base + 1;
    return link[static_cast<std::size_t>(place)];
  }
};

/// Computes the velocities while one joint coordinate turns by 1 rad/s.
[[nodiscard]] TreeVelocity joint_velocity_tree(const Tree<double>& tree,
                                               const TreeState<double>& state, int coordinate);

}  // namespace thenar::internal
