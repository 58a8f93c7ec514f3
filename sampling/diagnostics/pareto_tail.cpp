#include "sampling/diagnostics/pareto_tail.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "base/error.h"
#include "sampling/diagnostics/log_sum.h"

namespace thenar {
namespace {

/// k of the profile likelihood at b = -k / sigma.
double shape_at(double b, const Eigen::VectorXd& x) { return (-b * x).array().log1p().mean(); }

/// Order statistic expected at share p.
double pareto_quantile(double p, const ParetoFit& fit) {
  if (std::abs(fit.k) < 1e-12) return -fit.sigma * std::log1p(-p);
  return fit.sigma * std::expm1(-fit.k * std::log1p(-p)) / fit.k;
}

}  // namespace

ParetoFit fit_pareto(const Eigen::Ref<const Eigen::VectorXd>& rising) {
  const Eigen::Index n = rising.size();
  require(n >= 5, "a Pareto tail needs 5 excesses, got {}", n);
  require(rising[0] >= 0 && rising[n - 1] > 0 && std::isfinite(rising[n - 1]),
          "excesses must be positive and finite, got {} to {}", rising[0], rising[n - 1]);

  // A grid of b with the prior of Zhang and Stephens, about three times the quartile.
  const auto quarter = Eigen::Index(std::floor(double(n) / 4 + 0.5)) - 1;
  const double quartile = rising[quarter] > 0 ? rising[quarter] : rising[n - 1] / double(n);
  const int points = 30 + int(std::sqrt(double(n)));
  Eigen::VectorXd b(points), log_likelihood(points);
  for (int i = 0; i < points; ++i) {
    b[i] = 1 / rising[n - 1] + (1 - std::sqrt(points / (i + 0.5))) / (3 * quartile);
    const double k = shape_at(b[i], rising);
    log_likelihood[i] = double(n) * (std::log(-b[i] / k) - k - 1);
  }
  for (double& of : log_likelihood)
    if (std::isnan(of)) of = -std::numeric_limits<double>::infinity();  // b = 0 to rounding

  const Eigen::VectorXd weight = (log_likelihood.array() - log_sum(log_likelihood)).exp();
  const double mean = weight.dot(b), k = shape_at(mean, rising);
  return {k, -k / mean};
}

SmoothedWeights smooth_weights(const Eigen::Ref<const Eigen::VectorXd>& log_ratio,
                               double efficiency) {
  const Eigen::Index n = log_ratio.size();
  require(n > 0 && log_ratio.allFinite(), "importance ratios must be finite");
  SmoothedWeights of;
  of.log_weight = log_ratio.array() - log_ratio.maxCoeff();
  of.k = std::numeric_limits<double>::infinity();

  std::vector<Eigen::Index> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return of.log_weight[a] < of.log_weight[b] || (of.log_weight[a] == of.log_weight[b] && a < b);
  });
  const double wanted = std::ceil(std::min(0.2 * double(n), 3 * std::sqrt(double(n) / efficiency)));
  const auto tail = Eigen::Index(wanted);

  if (tail >= 5 && tail < n) {
    const double cut = std::exp(of.log_weight[order[n - tail - 1]]);
    Eigen::VectorXd excess(tail);
    for (Eigen::Index i = 0; i < tail; ++i)
      excess[i] = std::exp(of.log_weight[order[n - tail + i]]) - cut;
    if (excess[tail - 1] > std::numeric_limits<double>::epsilon()) {
      ParetoFit fit = fit_pareto(excess);
      fit.k = (double(tail) * fit.k + 5) / (double(tail) + 10);
      of.k = fit.k;
      for (Eigen::Index i = 0; i < tail; ++i) {
        const double share = (double(i) + 0.5) / double(tail);
        of.log_weight[order[n - tail + i]] =
            std::min(0.0, std::log(cut + pareto_quantile(share, fit)));
      }
    } else {
      of.k = 0;  // all ratios of the tail are alike: nothing is heavier than anything
    }
  }
  of.log_weight.array() -= log_sum(of.log_weight);
  return of;
}

}  // namespace thenar
