#pragma once

/// Chains as a page draws them: traces, counts of ranks, autocorrelations.

#include <vector>

#include <Eigen/Core>

#include "report/draws/draws.h"

namespace thenar {

/// Returns a block with traces, rank histograms and autocorrelations of selectable quantities, the
/// one with the largest R-hat first. More than 8 chains are shown by one chain of each group, ranks
/// by groups.
///
/// The band of ranks holds 95 % of the counts of one bin if all chains draw from one distribution,
/// each with its own autocorrelation: a chain of n draws is worth n / tau, tau by Geyer's
/// initial positive sequence. Source: [Vehtari2021] for rank plots, [Geyer1992].
[[nodiscard]] Json chains_block(const std::vector<Quantity>& quantities,
                                const std::string& caption);

/// Counts the draws of each chain in equal bins of the ranks of all draws  (bins, chains).
/// @param x  (draws, chains)
[[nodiscard]] Eigen::MatrixXd rank_counts(const Eigen::Ref<const Eigen::MatrixXd>& x, int bins);

/// Returns the integrated autocorrelation time of a chain in steps: 1 + 2 sum of its
/// autocorrelations, up to the first pair with a sum that is not positive; at least 1. NaN if its
/// draws are all equal or not finite.
/// @param rho  autocorrelations at lags 0, 1, ... (any)
/// Source: [Geyer1992] sec. 3.3, the initial positive sequence.
[[nodiscard]] double correlation_time(const Eigen::Ref<const Eigen::VectorXd>& rho);

/// Returns the autocorrelations of a chain at lags 0, 1, ... (draws); NaN as above.
[[nodiscard]] Eigen::VectorXd autocorrelation(const Eigen::Ref<const Eigen::VectorXd>& x);

/// Interval that holds a count with 95 % probability.
struct CountBand {
  double low, high;
};

/// Computes the band of the count in one bin of one of several chains with the same distribution.
/// The count of independent draws is hypergeometric with variance  n p (1 - p) (N - n) / (N - 1),
/// n of N draws and p = 1/bins; correlated draws have tau times that variance. Normal
/// approximation.
/// @param draws  draws of one chain [1]
/// @param tau    autocorrelation time of a chain [1]
[[nodiscard]] CountBand rank_band(double draws, double chains, int bins, double tau);

/// Returns true if R-hat a is worse than b, for sorting with the worst first; NaN is the worst.
[[nodiscard]] bool worse(double a, double b);
/// Returns the quantities, the largest R-hat first.
[[nodiscard]] std::vector<const Quantity*> worst_first(const std::vector<Quantity>& quantities);

}  // namespace thenar
