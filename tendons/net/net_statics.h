#pragma once

/// Forces of a net on the bones.

#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"
#include "hand/statics.h"
#include "tendons/net/solve_net.h"

namespace thenar {

/// Computes the joint torque of the net by virtual work,  tau = -dE/dq  at fixed floating nodes;
/// muscle tensions and contacts included [N m] (coordinates).
[[nodiscard]] Eigen::VectorXd net_torque(const Net& net, const Tree<double>& tree,
                                         const TreeState<double>& state, const NetEquilibrium& rest,
                                         int coordinates);

/// Computes the energy stored in the passive bands [J]; bands of muscles store none.
[[nodiscard]] double strain_energy(const Net& net, const NetEquilibrium& rest);

/// Computes the wrenches of the net on all links, the base first. They sum to zero except for the
/// forces on the exits of muscles given by tension, whose bodies are links as well.
[[nodiscard]] std::vector<LinkWrench> net_wrenches(const Net& net, const TreeState<double>& state,
                                                   const NetEquilibrium& rest);

}  // namespace thenar
