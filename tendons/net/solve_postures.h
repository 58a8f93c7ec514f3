#pragma once

/// One net at rest at many postures.

#include <vector>

#include "tendons/net/solve_net.h"

namespace thenar {

/// Brings the net to rest at one posture after another, each time from where it lay at the last one
/// at which it was balanced: a net on bone stays on the side of a joint on which it came.
/// @param postures  [rad] (coordinates) each
/// @param start     nodes to start from at the first one, world [m] (3, nodes); empty: each with
/// its
///                  link
/// @throws InputError as NetSolver::solve(), or naming a posture of too few coordinates.
[[nodiscard]] std::vector<NetEquilibrium> solve_postures(
    NetSolver& solver, const Tree<double>& tree, const std::vector<Eigen::VectorXd>& postures,
    const NetDrive& drive, Eigen::Matrix3Xd start = {});

}  // namespace thenar
