// Monte Carlo standard errors.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/special_functions.h"
#include "sampling/diagnostics/chain_parts.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {

double mean_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x) { return mean_mcse(x, {}); }

double mean_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x, const std::vector<int>& group) {
  const double variance = (x.array() - x.mean()).square().sum() / double(x.size() - 1);
  return std::sqrt(variance / mean_ess(x, group));
}

double sd_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  const Eigen::ArrayXXd square = (x.array() - x.mean()).square();
  const double variance = square.mean();
  const double of_variance = (square.square().mean() - variance * variance) / sd_ess(x);
  return std::sqrt(of_variance / variance) / 2;
}

double quantile_mcse(const Eigen::Ref<const Eigen::MatrixXd>& x, double share) {
  const double ess = quantile_ess(x, share);
  if (std::isnan(ess)) return ess;

  // Where the quantile may lie, as shares of the draws: 16 and 84 % of its posterior.
  constexpr double kOneSigma = 0.15865525393145707;
  const double a = ess * share + 1, b = ess * (1 - share) + 1;
  const double low = beta_quantile(kOneSigma, a, b), high = beta_quantile(1 - kOneSigma, a, b);

  const Eigen::VectorXd rising = sorted(x);
  const double n = double(rising.size());
  const auto first = Eigen::Index(std::floor(std::max(0.0, low * n - 1)));
  const auto last = Eigen::Index(std::ceil(std::min(n - 1, high * n - 1)));
  return (rising[last] - rising[first]) / 2;
}

}  // namespace thenar
