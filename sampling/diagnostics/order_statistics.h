#pragma once

/// Ranks, normal scores and quantiles of draws.

#include <Eigen/Core>

namespace thenar {

/// Computes ranks 1 .. N among all entries; ties share the mean of their ranks [1] (shape of x).
/// @param x  of any shape, without NaN
[[nodiscard]] Eigen::MatrixXd average_ranks(const Eigen::Ref<const Eigen::MatrixXd>& x);

/// Computes normal scores: the quantile of N(0, 1) at (rank - 3/8) / (N + 1/4) [1] (shape of x).
/// Source: [Vehtari2021] eq. 14, after [Blom1958].
[[nodiscard]] Eigen::MatrixXd normal_scores(const Eigen::Ref<const Eigen::MatrixXd>& x);

/// Returns all entries in ascending order (N).
/// @param x  of any shape, without NaN
[[nodiscard]] Eigen::VectorXd sorted(const Eigen::Ref<const Eigen::MatrixXd>& x);

/// Computes a quantile of sorted draws, linear between order statistics: type 7 of
/// [HyndmanFan1996].
/// @param rising  at least one draw, in ascending order (N)
/// @param share   probability, 0..1 [1]
/// @throws InputError if there is no draw, or share is out of range.
[[nodiscard]] double quantile(const Eigen::Ref<const Eigen::VectorXd>& rising, double share);

}  // namespace thenar
