#pragma once

/// What can be changed about a net at rest, each as a rate.

#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/net/net.h"

namespace thenar::internal {

/// Velocity of a rigid body.
struct BodyRate {
  Eigen::Vector3d v{0, 0, 0};  // of its point at the world's origin (3)
  Eigen::Vector3d w{0, 0, 0};  // angular (3)
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& p) const { return v + w.cross(p); }
};

/// How everything moves by one input, the floating nodes excepted.
struct NetInput {
  std::vector<BodyRate> link;                // the base first
  std::vector<Eigen::Vector3d> axis, point;  // of the hinges
  Eigen::VectorXd tension;                   // of each band at a fixed length (bands)
  [[nodiscard]] const BodyRate& body(int link_or_base) const {
    return link[static_cast<std::size_t>(link_or_base + 1)];
  }
};

/// Nothing moves and no tension changes.
[[nodiscard]] NetInput still(const Net& net, std::size_t links);

/// One joint coordinate turns by 1 rad.
[[nodiscard]] NetInput turning(const Net& net, const Tree<double>& tree,
                               const TreeState<double>& state, int coordinate);

}  // namespace thenar::internal
