#include "sampling/diagnostics/importance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/numbers.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/leave_one_out.h"

namespace thenar {

namespace {

/// Returns the efficiency of the mean of draws, stored chain by chain; 1 for independent draws.
double efficiency_of_draws(const Eigen::VectorXd& x, int chains) {
  if (chains == 0) return 1;
  require(chains > 0 && x.size() % chains == 0 && x.size() / chains >= 4,
          "wanted {} chains of one length, of 4 draws or more, got {} draws", chains, x.size());
  return mean_efficiency(x.reshaped(x.size() / chains, chains));
}

}  // namespace

double good_pareto_shape(double draws) { return std::min(1 - 1 / std::log10(draws), 0.7); }

ImportanceWeights importance_weights(const Eigen::Ref<const Eigen::VectorXd>& log_ratio,
                                     int chains) {
  // Select draws with a finite ratio.
  std::vector<Eigen::Index> inside;
  for (Eigen::Index i = 0; i < log_ratio.size(); ++i) {
    require(!std::isnan(log_ratio[i]) && log_ratio[i] < kInfinity,
            "an importance ratio must be a number, the logarithm of that of draw {} is {}", i,
            log_ratio[i]);
    if (std::isfinite(log_ratio[i])) inside.push_back(i);
  }
  require(!inside.empty(), "none of {} draws can be weighed", log_ratio.size());

  // Smooth the tail of their ratios.
  Eigen::VectorXd finite(static_cast<Eigen::Index>(inside.size()));
  for (std::size_t i = 0; i < inside.size(); ++i)
    finite[static_cast<Eigen::Index>(i)] = log_ratio[inside[i]];
  const Eigen::VectorXd ratio = (log_ratio.array() - finite.maxCoeff()).exp();
  const SmoothedWeights smoothed = smooth_weights(finite, efficiency_of_draws(ratio, chains));

  // Assign zero weight to all others.
  ImportanceWeights out;
  out.weight = Eigen::VectorXd::Zero(log_ratio.size());
  for (std::size_t i = 0; i < inside.size(); ++i)
    out.weight[inside[i]] = std::exp(smoothed.log_weight[static_cast<Eigen::Index>(i)]);
  out.effective_size = 1 / out.weight.squaredNorm();
  out.k = smoothed.k;
  out.good_k = good_pareto_shape(static_cast<double>(inside.size()));
  return out;
}

WeightedSpread weighted_spread(const Eigen::Ref<const Eigen::MatrixXd>& x,
                               const Eigen::Ref<const Eigen::VectorXd>& weight, int chains) {
  const Eigen::Index N = x.cols();
  require(weight.size() == N && N >= 2, "{} draws cannot have {} weights", N, weight.size());
  WeightedSpread out;
  out.mean = x * weight;
  out.sd = out.mean_shift = out.sd_ratio = out.sd_ratio_error = out.mean;
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    // Compute squared deviations, unweighted and weighted.
    const double plain_mean = x.row(i).mean();
    const Eigen::VectorXd plain = (x.row(i).array() - plain_mean).square().matrix().transpose(),
                          about = (x.row(i).array() - out.mean[i]).square().matrix().transpose();
    const double plain_variance = plain.mean(), variance = weight.dot(about);
    require(plain_variance > 0 && variance > 0, "entry {} of the draws does not vary", i);

    // Compute their ratio and its error.
    out.sd[i] = std::sqrt(variance);
    out.mean_shift[i] = (out.mean[i] - plain_mean) / std::sqrt(plain_variance);
    out.sd_ratio[i] = std::sqrt(variance / plain_variance);
    const Eigen::ArrayXd a = about.array() / variance - 1, b = plain.array() / plain_variance - 1;
    const Eigen::VectorXd terms = weight.array() * a - b / static_cast<double>(N);
    out.sd_ratio_error[i] =
        out.sd_ratio[i] / 2 * terms.norm() / std::sqrt(efficiency_of_draws(terms, chains));
  }
  return out;
}

}  // namespace thenar
