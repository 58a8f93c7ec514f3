#include "sampling/diagnostics/predictive.h"

#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {
namespace {

constexpr double kOddP = 0.01;  // distance of a p-value from 0 or 1 below which it is reported [1]
// Error of a coverage above which it is reported [standard errors]
constexpr double kOddCoverage = 3;

/// Checks shapes and values.
void check_shapes(const Eigen::VectorXd& measured, const Replicates& replicates, int trial_size) {
  const Eigen::Index m = measured.size(), draws = replicates.expected.cols();
  require(m > 0 && draws > 0, "a check needs measured numbers and draws, got {} and {}", m, draws);
  require(trial_size > 0 && m % trial_size == 0, "{} numbers are not whole trials of {}", m,
          trial_size);
  // Shapes of the replicates.
  require(replicates.expected.rows() == m && replicates.replicated.rows() == m &&
              replicates.replicated.cols() == draws,
          "{} measured numbers, {} x {} expected, {} x {} replicated", m,
          replicates.expected.rows(), draws, replicates.replicated.rows(),
          replicates.replicated.cols());
  require(replicates.sd.rows() == m && (replicates.sd.cols() == draws || replicates.sd.cols() == 1),
          "noise sds are {} x {}, wanted {} x {} or 1", replicates.sd.rows(), replicates.sd.cols(),
          m, draws);
  // Finite numbers and positive sds.
  require(
      measured.allFinite() && replicates.expected.allFinite() && replicates.replicated.allFinite(),
      "measured, expected and replicated numbers must be finite");
  require(replicates.sd.allFinite() && replicates.sd.minCoeff() > 0, "noise sds must be positive");
}

/// Returns the sums of squared standardised residuals over each trial (trials, draws).
Eigen::MatrixXd chi_squares(const Eigen::MatrixXd& numbers, const Replicates& replicates,
                            int trial_size) {
  const Eigen::Index trials = numbers.rows() / trial_size;
  Eigen::MatrixXd sums(trials, replicates.expected.cols());
  for (Eigen::Index s = 0; s < sums.cols(); ++s) {
    // Measured numbers are equal for all draws.
    const Eigen::VectorXd y = numbers.col(numbers.cols() == 1 ? 0 : s);
    const Eigen::VectorXd sd = replicates.sd.col(replicates.sd.cols() == 1 ? 0 : s);
    const Eigen::VectorXd square = ((y - replicates.expected.col(s)).array() / sd.array()).square();
    sums.col(s) = square.reshaped(trial_size, trials).colwise().sum().transpose();
  }
  return sums;
}

/// Returns the share of draws with a larger replicated than measured statistic; ties count half.
double exceedance(const Eigen::VectorXd& replicated, const Eigen::VectorXd& measured) {
  const auto off = (replicated - measured).array();
  return ((off > 0).cast<double>() + 0.5 * (off == 0).cast<double>()).mean();
}

/// Computes the coverage of central intervals.
Coverage cover(const Eigen::VectorXd& measured, const Eigen::MatrixXd& replicated, double level) {
  long inside = 0;
  for (Eigen::Index i = 0; i < measured.size(); ++i) {
    // Compare with the central interval of the replicates.
    const Eigen::VectorXd rising = sorted(replicated.row(i));
    if (measured[i] >= quantile(rising, (1 - level) / 2) &&
        measured[i] <= quantile(rising, (1 + level) / 2))
      ++inside;
  }
  const auto m = double(measured.size());
  return {level, double(inside) / m, std::sqrt(level * (1 - level) / m)};
}

std::vector<std::string> predictive_warnings(const PredictiveCheck& check) {
  std::vector<std::string> warnings;
  // Total chi-square.
  if (check.p < kOddP || check.p > 1 - kOddP)
    warnings.push_back(
        fmt::format("{:.3g} % of replicated measurements are further from the model "
                    "than the measured ones: the model is too {}",
                    100 * check.p, check.p < 0.5 ? "sure" : "unsure"));
  // Single trials, with a shared limit.
  for (Eigen::Index t = 0; t < check.trial_p.size(); ++t)
    if (check.trial_p[t] < kOddP / double(check.trial_p.size()))
      warnings.push_back(fmt::format("trial {} is further off than {:.4g} % of its replicates",
                                     t + 1, 100 * (1 - check.trial_p[t])));
  // Coverage.
  for (const Coverage& interval : check.coverage)
    if (std::abs(interval.share - interval.level) > kOddCoverage * interval.error)
      warnings.push_back(fmt::format("{:.3g} % of measurements lie in their {:.3g} % intervals",
                                     100 * interval.share, 100 * interval.level));
  return warnings;
}

}  // namespace

PredictiveCheck check_predictive(const Eigen::Ref<const Eigen::VectorXd>& measured,
                                 const Replicates& replicates, int trial_size) {
  check_shapes(measured, replicates, trial_size);
  // Compute coverage, and the rank of each measurement among its replicates.
  PredictiveCheck check;
  for (const double level : {0.5, 0.8, 0.95})
    check.coverage.push_back(cover(measured, replicates.replicated, level));
  check.rank_share =
      ((replicates.replicated.colwise() - measured).array() < 0).cast<double>().rowwise().mean();

  // Compare chi-squares of measurements and replicates for the same draws.
  const Eigen::MatrixXd seen = chi_squares(measured, replicates, trial_size);
  const Eigen::MatrixXd again = chi_squares(replicates.replicated, replicates, trial_size);
  check.trial_p.resize(seen.rows());
  for (Eigen::Index t = 0; t < seen.rows(); ++t)
    check.trial_p[t] = exceedance(again.row(t).transpose(), seen.row(t).transpose());
  const Eigen::VectorXd all_seen = seen.colwise().sum(), all_again = again.colwise().sum();
  check.p = exceedance(all_again, all_seen);
  check.mean_chi_square = all_seen.mean();
  check.warnings = predictive_warnings(check);
  return check;
}

}  // namespace thenar
