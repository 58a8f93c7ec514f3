#pragma once

/// Simultaneous confidence band for the cumulative counts of uniform ranks.
/// Source: [Sailynoja2022] secs. 2.1-2.2.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Limits of the number of ranks, N in all and each 0 .. L, below several evaluation points. If the
/// ranks are independent and uniform, all counts are within their limits at once with at least the
/// requested probability.
struct RankBand {
  Eigen::VectorXi below;      // evaluation points: ranks < below, ascending, in 1 .. L (points)
  Eigen::VectorXi low, high;  // inclusive limits of the count (points)
  double pointwise = 0;       // level of each pair of limits alone: 1 - gamma [1]
};

/// Computes the band. Limits are binomial quantiles at gamma / 2 and 1 - gamma / 2, with the
/// largest gamma for which the exact probability of staying inside is at least `level`.
/// @param ranks   N, number of ranks
/// @param draws   L, the largest possible rank
/// @param points  number of evaluation points, at most L
/// @throws InputError if arguments are not positive, or level is not in (0, 1).
[[nodiscard]] RankBand uniform_rank_band(int ranks, int draws, int points, double level = 0.95);

/// Computes the exact p-value of uniformity: the probability that uniform ranks deviate somewhere
/// at least as far, pointwise, as these ranks do [1].
/// @param rank  ranks, each 0 .. L (N)
[[nodiscard]] double uniform_rank_p(const Eigen::VectorXi& rank, int draws, int points);

/// Counts the ranks below each point (points).
[[nodiscard]] Eigen::VectorXi count_below(const Eigen::VectorXi& rank,
                                          const Eigen::VectorXi& below);

}  // namespace thenar
