#pragma once

/// A gap in a line of draws.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Where a density of one variable is lowest between two peaks.
struct Valley {
  double cut = 0;       // the place [unit of y]
  double depth = 1;     // density there over that of the lower peak; 1: there is no valley
  double contrast = 0;  // (lower peak - valley) (n h / ((peak + valley) / (2 sqrt(pi))))^1/2 [1]
};

/// The deepest valley of a normal-kernel density with Silverman's bandwidth
/// h = 0.9 min(sd, quartile range / 1.349) n^-1/5  [Silverman1986 eq. 3.31], that leaves
/// `min_share` of the draws on either side. `contrast` is in standard errors of the density's
/// estimate if the draws are independent: multiply by sqrt(ESS / n) if they are not.
/// @param y  at least 2, finite (n)
[[nodiscard]] Valley find_valley(const Eigen::Ref<const Eigen::VectorXd>& y, double min_share);

// Directions along which draws may fall apart.

/// Unit directions to look along: every coordinate; where chains lie apart; and where the kurtosis
/// of the whitened draws is locally least or greatest, which is where one cut separates two groups
/// of similar, and of very different, size [PenaPrieto2001]. The kurtosis is climbed by the fixed
/// point  w <- E[y (w'y)^3] - 3 w  [Hyvarinen1999].
/// @param x      draws (n, N)
/// @param chain  of each draw (N)
/// @return       (n, directions)
[[nodiscard]] Eigen::MatrixXd projection_directions(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                                    const std::vector<int>& chain);

// Draws told apart by gaps between them, knowing nothing of their density.

struct ClusterOptions {
  double min_mass = 0.01;  // of a cluster, as a share of all draws [1]
  double depth = 0.5;      // deepest valley that is none: density over that of the lower peak [1]
  double contrast = 5;     // least, in standard errors of the density [1]
  long draws = 10000;      // that are looked at, evenly spread; all are sorted in the end [1]
};

/// Cuts the draws by a plane across the deepest valley of any of projection_directions(), and the
/// parts again, until no valley is deep and certain enough.
///
/// It cannot see: clusters lighter than min_mass; clusters whose shadows overlap along every
/// straight line (a ring around a core, two interlocked bows); clusters nearer than about 3.3 sds
/// of a normal; and what no chain has visited.
/// @param x  of each chain (n, draws)
/// @return   cluster of each draw, 0 .. clusters - 1, heaviest first (draws, chains)
/// @throws InputError if a draw is not finite.
[[nodiscard]] Eigen::MatrixXi find_clusters(const std::vector<Eigen::MatrixXd>& x,
                                            const ClusterOptions& options = {});

/// Numbers from 0 by falling frequency in place of whatever labels there are (shape of labels).
[[nodiscard]] Eigen::MatrixXi by_falling_mass(const Eigen::MatrixXi& labels);

}  // namespace thenar
