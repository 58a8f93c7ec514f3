#pragma once

/// Chains as a page draws them: traces, counts of ranks, autocorrelations.

#include <vector>

#include <Eigen/Core>

#include "report/draws/draws.h"

namespace thenar {

/// Returns traces, rank histograms and autocorrelations, the quantity with the largest R-hat first;
/// the reader chooses. More than 8 chains are shown by one chain of each group, ranks by groups.
///
/// The band of ranks holds 95 % of the counts of one bin if all chains draw from one distribution,
/// each as correlated within itself as it is: a chain of n draws is worth n / tau, tau by Geyer's
/// initial positive sequence. Source: [Vehtari2021] for rank plots, [Geyer1992].
[[nodiscard]] Json chains_block(const std::vector<Quantity>& quantities,
                                const std::string& caption);

/// Counts the draws of each chain in equal bins of the ranks of all draws  (bins, chains).
/// @param x  (draws, chains)
[[nodiscard]] Eigen::MatrixXd rank_counts(const Eigen::Ref<const Eigen::MatrixXd>& x, int bins);

/// Returns steps that a chain needs to forget: 1 + 2 sum of its autocorrelations, as long as sums
/// of neighbouring ones are positive; at least 1. NaN if its draws are alike or not finite.
/// @param rho  autocorrelations at lags 0, 1, ... (any)
/// Source: [Geyer1992] sec. 3.3, the initial positive sequence.
[[nodiscard]] double correlation_time(const Eigen::Ref<const Eigen::VectorXd>& rho);

/// Returns correlations of a chain with itself at lags 0, 1, ... (draws); NaN as above.
[[nodiscard]] Eigen::VectorXd autocorrelation(const Eigen::Ref<const Eigen::VectorXd>& x);

/// Interval that holds a count with 95 % probability.
struct CountBand {
  double low, high;
};

/// Counts of one bin of one of several chains of one distribution. A count of independent draws is
/// hypergeometric, of variance  n p (1 - p) (N - n) / (N - 1)  with n of N draws and p = 1/bins;
/// correlated ones have tau times that. Normal approximation.
/// @param draws  of one chain
/// @param tau    steps that a chain needs to forget [1]
[[nodiscard]] CountBand rank_band(double draws, double chains, int bins, double tau);

/// Returns true if R-hat a is worse than b, for sorting with the worst first; NaN is the worst.
[[nodiscard]] bool worse(double a, double b);
/// Returns quantities, the largest R-hat first.
[[nodiscard]] std::vector<const Quantity*> worst_first(const std::vector<Quantity>& quantities);

}  // namespace thenar
