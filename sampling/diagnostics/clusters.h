#pragma once

/// Clustering of draws at low-density gaps, without evaluating the density.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Minimum of a density of one variable between two peaks.
struct Valley {
  double cut = 0;  // position of the minimum [unit of y]
  double depth =
      1;  // density at the minimum over density of the lower peak; 1: there is no valley [1]
  double contrast = 0;  // (lower peak - valley) (n h / ((peak + valley) / (2 sqrt(pi))))^1/2 [1]
};

/// Finds the deepest valley that leaves at least `min_share` of the draws on either side, in a
/// normal-kernel density with Silverman's bandwidth  h = 0.9 min(sd, quartile range / 1.349) n^-1/5
/// [Silverman1986 eq. 3.31]. `contrast` is in standard errors of the density's estimate if the
/// draws are independent; multiply it by sqrt(ESS / n) if they are not.
/// @param y  draws, at least 2, finite (n)
[[nodiscard]] Valley find_valley(const Eigen::Ref<const Eigen::VectorXd>& y, double min_share);

/// Returns unit directions along which clusters may separate: every coordinate; the differences
/// between chain means; and the directions of locally minimal or maximal kurtosis of the whitened
/// draws, where one cut separates two groups of similar or of very different size [PenaPrieto2001].
/// Extrema of the kurtosis are found by the fixed-point iteration  w <- E[y (w'y)^3] - 3 w
/// [Hyvarinen1999].
/// @param x      draws (n, N)
/// @param chain  index of the chain of each draw (N)
/// @return       unit columns (n, directions)
[[nodiscard]] Eigen::MatrixXd projection_directions(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                                    const std::vector<int>& chain);

/// Criteria by which a valley separates two clusters.
struct ClusterOptions {
  double min_mass = 0.01;  // minimum mass of a cluster, as a share of all draws [1]
  double depth = 0.5;      // maximum density of a valley over that of the lower peak [1]
  double contrast = 5;     // minimum contrast of a valley, in standard errors of the density [1]
  long draws = 10000;  // number of draws, evenly thinned, used to find the planes; all draws are
                       // labelled [1]
};

/// Cuts the draws by a plane through the deepest valley along any of projection_directions(), and
/// repeats for both parts until no valley satisfies the criteria.
///
/// Limitations: it does not find clusters lighter than min_mass; clusters whose projections overlap
/// along every straight line (a ring around a core, two interlocked arcs); clusters of a normal
/// mixture nearer than about 3.3 sds; and modes that no chain has visited.
/// @param x  draws of each chain (n, draws)
/// @return   cluster of each draw, 0 .. clusters - 1, heaviest first (draws, chains)
/// @throws InputError if a draw is not finite.
[[nodiscard]] Eigen::MatrixXi find_clusters(const std::vector<Eigen::MatrixXd>& x,
                                            const ClusterOptions& options = {});

/// Renumbers labels from 0 by falling frequency (shape of labels).
[[nodiscard]] Eigen::MatrixXi relabel_by_mass(const Eigen::MatrixXi& labels);

}  // namespace thenar
