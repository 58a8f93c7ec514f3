// Effective sample sizes.

#include "sampling/diagnostics/effective_sample_size.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"
#include "sampling/diagnostics/autocovariance.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/order_statistics.h"
#include "sampling/diagnostics/split_chains.h"

namespace thenar {
namespace {

// Number of lags of a first attempt: usually sufficient, and cheap
constexpr Eigen::Index kInitialLagCount = 100;

/// Returns the autocorrelation of all chains together, at lags 0 .. lags - 1 [Vehtari2021 eq. 10].
Eigen::VectorXd autocorrelation_of_all(const Eigen::MatrixXd& x, Eigen::Index lags) {
  // Average the autocovariance over the chains.
  const auto n = double(x.rows()), m = double(x.cols());
  Eigen::VectorXd covariance = Eigen::VectorXd::Zero(lags);
  for (Eigen::Index chain = 0; chain < x.cols(); ++chain)
    covariance += autocovariance(x.col(chain), lags) / m;

  // Compute the variance of all chains together, including differences of their means.
  const Eigen::RowVectorXd mean = x.colwise().mean();
  const double within = covariance[0] * n / (n - 1);
  const double all = covariance[0] + (mean.array() - mean.mean()).square().sum() / (m - 1);
  Eigen::VectorXd rho = 1 - (within - covariance.array()) / all;
  rho[0] = 1;
  return rho;
}

/// Returns the first lag of the pair at which the sum ends.
Eigen::Index last_pair(const Eigen::VectorXd& rho) {
  Eigen::Index lag = 0;
  while (lag + 4 < rho.size() && rho[lag] + rho[lag + 1] > 0) lag += 2;
  return lag;
}

/// Returns the autocorrelation time of all chains together.
double time_of_all(const Eigen::MatrixXd& x) {
  if (x.rows() > kInitialLagCount) {
    const Eigen::VectorXd few = autocorrelation_of_all(x, kInitialLagCount);
    if (last_pair(few) + 4 < few.size()) return autocorrelation_time(few);
  }
  return autocorrelation_time(autocorrelation_of_all(x, x.rows()));
}

/// Returns the effective size, at most N log10 N, beyond which the noise of rho dominates.
double effective_size(const Eigen::MatrixXd& x) {
  if (!finite_and_varying(x)) return kNaN;
  const auto size = double(x.size());
  return size / std::max(time_of_all(x), 1 / std::log10(size));
}

/// Returns indicators of x <= limit.
Eigen::MatrixXd at_most(const Eigen::Ref<const Eigen::MatrixXd>& x, double limit) {
  return (x.array() <= limit).cast<double>();
}

}  // namespace

double autocorrelation_time(const Eigen::VectorXd& rho) {
  const Eigen::Index end = last_pair(rho);
  double sum = 0, min_pair_sum = std::numeric_limits<double>::infinity();
  for (Eigen::Index lag = 0; lag < end; lag += 2) {
    min_pair_sum = std::min(min_pair_sum, rho[lag] + rho[lag + 1]);
    sum += min_pair_sum;
  }
  return -1 + 2 * sum + std::max(0.0, rho[end]);
}

double series_ess(const Eigen::Ref<const Eigen::VectorXd>& x) {
  if (!finite_and_varying(x)) return kNaN;
  const Eigen::VectorXd covariance = autocovariance(x);
  const auto size = double(x.size());
  return size / std::max(autocorrelation_time(covariance / covariance[0]), 1 / std::log10(size));
}

double ensemble_ess(const Eigen::Ref<const Eigen::MatrixXd>& x, const std::vector<int>& group) {
  if (!finite_and_varying(x)) return kNaN;
  const Eigen::MatrixXd pooled = pool_groups(x, group);  // interleaves walkers
  const Eigen::Index walkers = pooled.rows() / x.rows();
  // Average over the walkers of each group, for each draw.
  const Eigen::MatrixXd means = pooled.reshaped(walkers, x.rows() * pooled.cols())
                                    .colwise()
                                    .mean()
                                    .reshaped(x.rows(), pooled.cols());
  const auto variance = [](const Eigen::MatrixXd& y) {
    return (y.array() - y.mean()).square().mean();
  };
  return mean_ess(means) * variance(x) / variance(means);
}

double bulk_ess(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  const Eigen::MatrixXd halves = split_chains(x);
  if (!finite_and_varying(halves)) return kNaN;
  return effective_size(normal_scores(halves));
}

double mean_ess(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  return effective_size(split_chains(x));
}

double mean_ess(const Eigen::Ref<const Eigen::MatrixXd>& x, const std::vector<int>& group) {
  const double of_chains = mean_ess(x);
  if (group.empty() || pool_groups(x, group).cols() == x.cols()) return of_chains;
  return std::min(of_chains, ensemble_ess(x, group));
}

double mean_efficiency(const Eigen::Ref<const Eigen::MatrixXd>& x, const std::vector<int>& group) {
  const double size = mean_ess(x, group);
  return std::isnan(size) ? 1 : size / static_cast<double>(x.size());
}

double quantile_ess(const Eigen::Ref<const Eigen::MatrixXd>& x, double share) {
  (void)split_chains(x);  // checks the number of draws
  if (!finite_and_varying(x)) return kNaN;
  return effective_size(split_chains(at_most(x, quantile(sorted(x), share))));
}

double tail_ess(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  (void)split_chains(x);
  if (!finite_and_varying(x)) return kNaN;
  // Return the smaller one of the 5 and 95 % quantiles.
  const Eigen::VectorXd rising = sorted(x);
  const double low = effective_size(split_chains(at_most(x, quantile(rising, 0.05))));
  const double high = effective_size(split_chains(at_most(x, quantile(rising, 0.95))));
  return low <= high || std::isnan(low) ? low : high;
}

double sd_ess(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  return mean_ess((x.array() - x.mean()).square().matrix());
}

}  // namespace thenar
