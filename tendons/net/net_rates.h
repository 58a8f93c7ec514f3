#pragma once

/// How a net at rest follows an input.

#include "tendons/net/net_input.h"
#include "tendons/net/tangent_net.h"

namespace thenar::internal {

/// Rate of one band.
struct BandRate {
  double length, tension;
  Eigen::Vector3d fa, fb;  // of the force on its ends (3)
};

/// @param v  of all nodes (3, nodes)
[[nodiscard]] BandRate band_rate(const TangentNet& tangent, Eigen::Index band,
                                 const NetInput& input, const Eigen::Matrix3Xd& v);

/// Rate of the force that bands and bones leave on each floating node, drawn bands left out:
/// balance asks for 0 along the free directions. (3, floating nodes)
[[nodiscard]] Eigen::Matrix3Xd force_rate(const TangentNet& tangent, const NetInput& input,
                                          const Eigen::Matrix3Xd& v);

/// Velocity of all nodes, such that those that float keep on their bones and in balance.
/// (3, nodes)
[[nodiscard]] Eigen::Matrix3Xd node_rates(const TangentNet& tangent, const NetInput& input);

/// Rate of the joint torque  sum over links and their hinges of  ratio axis . (m - point x f).
/// @param v  from node_rates() (3, nodes)
[[nodiscard]] Eigen::VectorXd torque_rate(const TangentNet& tangent, const Tree<double>& tree,
                                          const TreeState<double>& state, const NetInput& input,
                                          const Eigen::Matrix3Xd& v, int coordinates);

}  // namespace thenar::internal
