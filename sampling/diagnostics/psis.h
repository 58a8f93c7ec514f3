#pragma once

/// How well a model would have predicted each observation from all the others.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sampling/diagnostics/pareto_tail.h"

namespace thenar {

/// Expected log predictive density by Pareto-smoothed importance sampling.
struct LeaveOneOut {
  double elpd = 0;                  // sum of `pointwise` [1]
  double se = 0;                    // of elpd, over observations: sqrt(n var) [1]
  double effective_parameters = 0;  // p_loo: log density of the data seen, less that unseen [1]
  Eigen::VectorXd pointwise;        // log p(y_i | y_-i) (observations)
  Eigen::VectorXd k;                // Pareto shape of each one's ratios (observations)
  double good_k = 0;  // above, the estimate is not to be trusted: min(1 - 1/log10 N, 0.7)
  std::vector<std::string> doubts;  // sentences; empty: trustworthy
};

/// Leave-one-out from draws that have seen everything:
///   log p(y_i | y_-i) = log sum_s w_is p(y_i | x_s),   w_is ~ 1 / p(y_i | x_s), smoothed.
/// Observations must be independent given x.
/// @param log_likelihood  finite; draws chain by chain (observations, draws * chains)
/// @param chains          by which the draws' efficiency is told
/// @param group           of each chain, walkers of one ensemble share theirs; empty: none do
/// @throws InputError if there are not 4 draws for every chain, or one is not finite.
/// Source: [Vehtari2017] eqs. 4, 10 and sec. 2; [Vehtari2024] for the limit of k.
[[nodiscard]] LeaveOneOut leave_one_out(const Eigen::Ref<const Eigen::MatrixXd>& log_likelihood,
                                        int chains, const std::vector<int>& group = {});

/// Difference in elpd of two models of the same observations, first less second, and its se.
struct ElpdDifference {
  double elpd = 0, se = 0;  // [1]
};

/// @throws InputError if they are of different numbers of observations.
/// Source: [Vehtari2017] eq. 24.
[[nodiscard]] ElpdDifference compare_elpd(const LeaveOneOut& first, const LeaveOneOut& second);

}  // namespace thenar
