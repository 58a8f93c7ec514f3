#pragma once

/// How moment arms of straight runs through via points change with posture, in closed form.

#include "tendons/path.h"

namespace thenar {

/// Slopes of moment_arms(),  dR_j/dq_k = -d2L/(dq_j dq_k),  symmetric.
///
/// Of one run r from a to b, u its direction, only hinges between its links count. With axis z_j
/// through c_j, r_j = z_j x (b - c_j) on the side of b and -z_j x (a - c_j) on that of a,
///   d2|r| = r_j . (1 - u u') r_k / |r| + u . (z_j x r_k),
/// j the hinge nearer the base; the last term only for two hinges of one side.
/// @return [m/rad^2] (coordinates, coordinates)
[[nodiscard]] Eigen::MatrixXd arm_slopes(const Tree<double>& tree, const TreeState<double>& state,
                                         const TendonPath<double>& path, int coordinates);

}  // namespace thenar
