#pragma once

/// What a net at rest does to the bones, and how all of it changes.

#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/net/solve_net.h"

namespace thenar {

/// Joint torque of the net by virtual work,  tau = -dE/dq  at fixed floating nodes; muscles'
/// tension and contacts included [N m] (coordinates).
[[nodiscard]] Eigen::VectorXd net_torque(const Net& net, const Tree<double>& tree,
                                         const TreeState<double>& state, const NetEquilibrium& rest,
                                         int coordinates);

/// Wrench of the net on a link, world axes, about the world origin.
struct LinkWrench {
  int link;           // -1: the base
  Eigen::Vector3d m;  // moment [N m] (3)
  Eigen::Vector3d f;  // force [N] (3)
};

/// Wrenches on all links that the net touches, the base too: they sum to zero but for the exits of
/// muscles given by tension, whose bodies are links as well.
[[nodiscard]] std::vector<LinkWrench> net_wrenches(const Net& net, const TreeState<double>& state,
                                                   const NetEquilibrium& rest);

/// Slopes of (x, tension, tau) by one group of inputs.
struct NetSlopes {
  Eigen::MatrixXd x;        // of all nodes, stacked (3 nodes, inputs)
  Eigen::MatrixXd tension;  // of all bands (bands, inputs)
  Eigen::MatrixXd tau;      // of the joint torque (coordinates, inputs)
};

/// By implicit differentiation at an equilibrium; one-sided where a band is exactly slack or a node
/// just touches.
struct NetDerivatives {
  NetSlopes by_posture;  // by q [1/rad]
  NetSlopes by_drive;    // by each muscle's tension [1/N], or length [1/m]
  NetSlopes by_EA;       // by each band's EA [1/N]
  NetSlopes by_slack;    // by each band's slack length [1/m]
};

/// @throws InputError if `rest` is not balanced.
[[nodiscard]] NetDerivatives net_derivatives(const Net& net, const Tree<double>& tree,
                                             const TreeState<double>& state, const NetDrive& drive,
                                             const NetEquilibrium& rest, int coordinates);

}  // namespace thenar
