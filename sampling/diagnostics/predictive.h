#pragma once

/// Posterior predictive checks: comparison of measurements with replicates drawn from the fitted
/// model.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Predictions of m measured numbers from posterior draws, in the unit of the numbers.
struct Replicates {
  Eigen::MatrixXd expected;    // expected values, without noise (m, draws)
  Eigen::MatrixXd replicated;  // replicated values, with noise (m, draws)
  Eigen::MatrixXd sd;          // noise sd, > 0 (m, draws), or (m, 1) if equal for all draws
};

/// Share of measured numbers inside the central interval of their replicates.
struct Coverage {
  double level = 0;  // nominal coverage, 0..1 [1]
  double share = 0;  // observed coverage, 0..1 [1]
  double error = 0;  // error of `share` for independent numbers: sqrt(level (1 - level) / m) [1]
};

/// Coverage and Bayesian p-values of the measurements.
struct PredictiveCheck {
  std::vector<Coverage> coverage;     // coverage of the 50, 80 and 95 % intervals
  Eigen::VectorXd rank_share;         // share of replicates below each measured number, 0..1 (m)
  Eigen::VectorXd trial_p;            // Bayesian p-value of every trial's chi-square, 0..1 (trials)
  double p = 0;                       // Bayesian p-value of the total chi-square, 0..1
  double mean_chi_square = 0;         // total chi-square, mean over draws [1]
  std::vector<std::string> warnings;  // sentences; empty: no check failed
};

/// Computes coverage and Bayesian p-values  P(T(y_rep, x) > T(y, x)), ties half, of
///   T(y, x) = sum_i ((y_i - f_i(x)) / sd_i)^2,
/// over each trial of `trial_size` numbers and over all. The model was fitted to the same data, so
/// that such a p-value is biased towards 1/2 and is not a significance level. Near 0, the model is
/// overconfident; near 1, underconfident.
/// @param measured  measured numbers, finite (m)
/// @throws InputError if shapes disagree, there are no draws, or numbers are not finite.
/// Source: [Gelman1996] eqs. 4, 9.
[[nodiscard]] PredictiveCheck check_predictive(const Eigen::Ref<const Eigen::VectorXd>& measured,
                                               const Replicates& replicates, int trial_size = 3);

}  // namespace thenar
