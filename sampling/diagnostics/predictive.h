#pragma once

/// Posterior predictive checks: measurements against replicates drawn from the fitted model.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Predictions of m measured numbers by draws of the posterior, in the unit of the numbers.
struct Replicates {
  Eigen::MatrixXd expected;    // without noise (m, draws)
  Eigen::MatrixXd replicated;  // with noise (m, draws)
  Eigen::MatrixXd sd;          // of the noise, > 0 (m, draws), or (m, 1) if it is the same in all
};

/// Share of measured numbers inside the central interval of their replicates.
struct Coverage {
  double level = 0;  // nominal, 0..1 [1]
  double share = 0;  // found, 0..1 [1]
  double error =
      0;  // of the share if the numbers were independent: sqrt(level (1 - level) / m) [1]
};

/// Coverage and Bayesian p-values of the measurements.
struct PredictiveCheck {
  std::vector<Coverage> coverage;     // of 50, 80 and 95 %
  Eigen::VectorXd rank_share;         // of replicates below each measured number, 0..1 (m)
  Eigen::VectorXd trial_p;            // Bayesian p of every trial's chi-square, 0..1 (trials)
  double p = 0;                       // of the whole chi-square, 0..1
  double mean_chi_square = 0;         // of the measured numbers, mean over draws [1]
  std::vector<std::string> warnings;  // sentences; empty: no check failed
};

/// Bayesian p-values  P(T(y_rep, x) > T(y, x)), ties half, of
///   T(y, x) = sum_i ((y_i - f_i(x)) / sd_i)^2,
/// over each trial of `trial_size` numbers and over all. Replicates depend on the data, so that
/// such a p is drawn towards 1/2 and is no level of a test; near 0 the model is too sure, near 1
/// too unsure.
/// @param measured  finite (m)
/// @throws InputError if shapes disagree, there are no draws, or numbers are not finite.
/// Source: [Gelman1996] eqs. 4, 9.
[[nodiscard]] PredictiveCheck check_predictive(const Eigen::Ref<const Eigen::VectorXd>& measured,
                                               const Replicates& replicates, int trial_size = 3);

}  // namespace thenar
