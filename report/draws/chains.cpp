#include "report/draws/chains.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "sampling/diagnostics/autocovariance.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {

Eigen::MatrixXd rank_counts(const Eigen::Ref<const Eigen::MatrixXd>& x, int bins) {
  const Eigen::MatrixXd ranks = average_ranks(x);  // 1 .. N
  const auto total = static_cast<double>(x.size());
  Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(bins, x.cols());
  for (Eigen::Index c = 0; c < x.cols(); ++c)
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
      const int bin = static_cast<int>((ranks(i, c) - 0.5) / total * bins);
      counts(std::clamp(bin, 0, bins - 1), c) += 1;
    }
  return counts;
}

Eigen::VectorXd autocorrelation(const Eigen::Ref<const Eigen::VectorXd>& x) {
  if (!x.allFinite() || x.maxCoeff() == x.minCoeff())
    return Eigen::VectorXd::Constant(x.size(), kNaN);
  const Eigen::VectorXd c = autocovariance(x);
  return c / c[0];
}

double correlation_time(const Eigen::Ref<const Eigen::VectorXd>& rho) {
  if (!rho.allFinite()) return kNaN;
  double sum = 0;
  for (Eigen::Index t = 0; t + 1 < rho.size(); t += 2) {
    const double pair = rho[t] + rho[t + 1];
    if (pair <= 0) break;
    sum += pair;
  }
  return std::max(1.0, 2 * sum - 1);
}

CountBand rank_band(double draws, double chains, int bins, double tau) {
  const double total = draws * chains, p = 1.0 / bins;
  const double variance =
      total > 1 ? tau * draws * p * (1 - p) * (total - draws) / (total - 1) : 0.0;
  const double mean = draws * p, reach = 1.96 * std::sqrt(variance);
  return {std::max(0.0, mean - reach), std::min(draws, mean + reach)};
}

bool worse(double a, double b) { return std::isnan(a) ? !std::isnan(b) : a > b; }

}  // namespace thenar
