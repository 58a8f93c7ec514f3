#pragma once

/// Are ranks uniform? A band that holds their whole cumulative count at once.
/// Source: [Sailynoja2022] secs. 2.1-2.2.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Counts of N ranks 0 .. L that are below each of several ranks: limits that hold all of them at
/// once with at least the asked probability, if the ranks are independent and uniform.
struct RankBand {
  Eigen::VectorXi below;      // evaluation points: ranks < below, rising, in 1 .. L (points)
  Eigen::VectorXi low, high;  // limits of the count, both allowed (points)
  double pointwise = 0;       // level of each limit pair alone: 1 - gamma [1]
};

/// Limits are binomial quantiles at gamma / 2 and 1 - gamma / 2; gamma is the largest at which the
/// exact probability to stay inside is at least `level`.
/// @param ranks   N, how many there will be
/// @param draws   L: ranks are 0 .. L
/// @param points  at which counts are looked at, at most L
/// @throws InputError if arguments are not positive, or level is not in (0, 1).
[[nodiscard]] RankBand uniform_rank_band(int ranks, int draws, int points, double level = 0.95);

/// Probability that uniform ranks somewhere stray as far, pointwise, as these do: the exact
/// p-value of uniformity. @param rank  each 0 .. L (N)
[[nodiscard]] double uniform_rank_p(const Eigen::VectorXi& rank, int draws, int points);

/// Counts of ranks below each point (points).
[[nodiscard]] Eigen::VectorXi count_below(const Eigen::VectorXi& rank,
                                          const Eigen::VectorXi& below);

}  // namespace thenar
