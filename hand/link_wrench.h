#pragma once

/// Wrenches on the links of a tree, and the joint torques that they make.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "hand/chain.h"

namespace thenar {

/// Wrench on one link, world axes, moment about the world origin.
struct LinkWrench {
  int link = -1;  // -1: the base
  Wrench wrench;  // per unit tension where it is a tendon's [N m], [N]
};

/// Joint torques of wrenches on links: about each hinge, the sum over all links that it moves.
/// Coupled joints share a coordinate by their ratios.
/// @return (coordinates) [N m]
[[nodiscard]] Eigen::VectorXd joint_torque(const Tree<double>& tree, const TreeState<double>& state,
                                           const std::vector<LinkWrench>& wrenches,
                                           int coordinates);

}  // namespace thenar
