#include "sampling/diagnostics/leave_one_out.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/importance.h"

namespace thenar {
namespace {

/// Returns the k of the profile likelihood at b = -k / sigma.
double shape_at(double b, const Eigen::VectorXd& x) { return (-b * x).array().log1p().mean(); }

/// Returns the quantile at probability p.
double pareto_quantile(double p, const ParetoFit& fit) {
  if (std::abs(fit.k) < 1e-12) return -fit.sigma * std::log1p(-p);
  return fit.sigma * std::expm1(-fit.k * std::log1p(-p)) / fit.k;
}

}  // namespace

double log_sum_exp(const Eigen::Ref<const Eigen::VectorXd>& x) {
  const double top = x.maxCoeff();
  return std::isfinite(top) ? top + std::log((x.array() - top).exp().sum()) : top;
}

ParetoFit fit_pareto(const Eigen::Ref<const Eigen::VectorXd>& rising) {
  const Eigen::Index n = rising.size();
  require(n >= 5, "a Pareto tail needs 5 excesses, got {}", n);
  require(rising[0] >= 0 && rising[n - 1] > 0 && std::isfinite(rising[n - 1]),
          "excesses must be positive and finite, got {} to {}", rising[0], rising[n - 1]);

  // Grid of b with the prior of Zhang and Stephens, around three times the quartile.
  const auto quarter = Eigen::Index(std::floor(double(n) / 4 + 0.5)) - 1;
  const double quartile = rising[quarter] > 0 ? rising[quarter] : rising[n - 1] / double(n);
  const int points = 30 + int(std::sqrt(double(n)));
  Eigen::VectorXd b(points), log_likelihood(points);
  for (int i = 0; i < points; ++i) {
    b[i] = 1 / rising[n - 1] + (1 - std::sqrt(points / (i + 0.5))) / (3 * quartile);
    const double k = shape_at(b[i], rising);
    log_likelihood[i] = double(n) * (std::log(-b[i] / k) - k - 1);
  }
  for (double& value : log_likelihood)
    if (std::isnan(value)) value = -std::numeric_limits<double>::infinity();  // b = 0 to rounding

  // Average b over the posterior on the grid.
  const Eigen::VectorXd weight = (log_likelihood.array() - log_sum_exp(log_likelihood)).exp();
  const double mean = weight.dot(b), k = shape_at(mean, rising);
  return {k, -k / mean};
}

SmoothedWeights smooth_weights(const Eigen::Ref<const Eigen::VectorXd>& log_ratio,
                               double efficiency) {
  const Eigen::Index n = log_ratio.size();
  require(n > 0 && log_ratio.allFinite(), "importance ratios must be finite");
  // Scale the largest ratio to 1.
  SmoothedWeights out;
  out.log_weight = log_ratio.array() - log_ratio.maxCoeff();
  out.k = std::numeric_limits<double>::infinity();

  // Find the tail of the largest ratios.
  std::vector<Eigen::Index> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return out.log_weight[a] < out.log_weight[b] ||
           (out.log_weight[a] == out.log_weight[b] && a < b);
  });
  const double wanted = std::ceil(std::min(0.2 * double(n), 3 * std::sqrt(double(n) / efficiency)));
  const auto tail = Eigen::Index(wanted);

  if (tail >= 5 && tail < n) {
    // Compute excesses over the largest ratio outside of the tail.
    const double cut = std::exp(out.log_weight[order[n - tail - 1]]);
    Eigen::VectorXd excess(tail);
    for (Eigen::Index i = 0; i < tail; ++i)
      excess[i] = std::exp(out.log_weight[order[n - tail + i]]) - cut;
    if (excess[tail - 1] > std::numeric_limits<double>::epsilon()) {
      // Replace them by quantiles of the fitted Pareto distribution.
      ParetoFit fit = fit_pareto(excess);
      fit.k = (double(tail) * fit.k + 5) / (double(tail) + 10);
      out.k = fit.k;
      for (Eigen::Index i = 0; i < tail; ++i) {
        const double share = (double(i) + 0.5) / double(tail);
        out.log_weight[order[n - tail + i]] =
            std::min(0.0, std::log(cut + pareto_quantile(share, fit)));
      }
    } else {
      out.k = 0;  // all ratios of the tail are equal
    }
  }
  out.log_weight.array() -= log_sum_exp(out.log_weight);
  return out;
}

namespace {

/// Returns sqrt(n var), the error of a sum of n terms.
double error_of_sum(const Eigen::VectorXd& terms) {
  const auto n = double(terms.size());
  return n < 2 ? std::nan("")
               : std::sqrt(n / (n - 1) * (terms.array() - terms.mean()).square().sum());
}

/// Returns effective over actual draws for the mean of the likelihood; 1 if it does not vary.
double efficiency_of(const Eigen::VectorXd& log_likelihood, int chains,
                     const std::vector<int>& group) {
  const Eigen::VectorXd likelihood = (log_likelihood.array() - log_likelihood.maxCoeff()).exp();
  return mean_efficiency(likelihood.reshaped(likelihood.size() / chains, chains), group);
}

}  // namespace

LeaveOneOut leave_one_out(const Eigen::Ref<const Eigen::MatrixXd>& log_likelihood, int chains,
                          const std::vector<int>& group) {
  const Eigen::Index draws = log_likelihood.cols(), observations = log_likelihood.rows();
  require(chains > 0 && draws % chains == 0 && draws / chains >= 4 && observations > 0,
          "leave-one-out needs observations and 4 draws a chain, got {} of {} chains for {}", draws,
          chains, observations);
  require(log_likelihood.allFinite(), "leave-one-out needs finite log likelihoods");

  // Allocate the results.
  LeaveOneOut out;
  out.good_k = good_pareto_shape(double(draws));
  out.pointwise.resize(observations);
  out.k.resize(observations);
  for (Eigen::Index i = 0; i < observations; ++i) {
    // Importance ratios are 1 / likelihood of this observation.
    const Eigen::VectorXd seen = log_likelihood.row(i).transpose();
    const SmoothedWeights weights = smooth_weights(-seen, efficiency_of(seen, chains, group));
    out.k[i] = weights.k;
    out.pointwise[i] = log_sum_exp(weights.log_weight + seen);
    out.effective_parameters += log_sum_exp(seen) - std::log(double(draws)) - out.pointwise[i];
  }
  // Sum over observations, and its error.
  out.elpd = out.pointwise.sum();
  out.se = error_of_sum(out.pointwise);

  // Warn about observations with unreliable weights.
  Eigen::Index worst;
  const double highest = out.k.maxCoeff(&worst);
  if (const long bad = (out.k.array() > out.good_k).count(); bad > 0)
    out.warnings.push_back(
        fmt::format("{} of {} observations have a Pareto k above {:.2f}, up to {:.2f} of number "
                    "{}: the draws do not reach where the posterior would be without them",
                    bad, observations, out.good_k, highest, worst + 1));
  return out;
}

ElpdDifference compare_elpd(const LeaveOneOut& first, const LeaveOneOut& second) {
  require(first.pointwise.size() == second.pointwise.size(),
          "models of {} and {} observations cannot be compared", first.pointwise.size(),
          second.pointwise.size());
  const Eigen::VectorXd difference = first.pointwise - second.pointwise;
  return {difference.sum(), error_of_sum(difference)};
}

}  // namespace thenar
