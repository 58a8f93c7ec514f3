#pragma once

/// Directions along which draws may fall apart.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Unit directions to look along: every coordinate; where chains lie apart; and where the kurtosis
/// of the whitened draws is locally least or greatest, which is where one cut separates two groups
/// of similar, and of very different, size [PenaPrieto2001]. The kurtosis is climbed by the fixed
/// point  w <- E[y (w'y)^3] - 3 w  [Hyvarinen1999].
/// @param x      draws (n, N)
/// @param chain  of each draw (N)
/// @return       (n, directions)
[[nodiscard]] Eigen::MatrixXd split_directions(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                               const std::vector<int>& chain);

}  // namespace thenar
