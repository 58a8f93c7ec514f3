// One quantity of a posterior.

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "sampling/diagnostics/chain_parts.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/effective_size.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {
namespace {

/// Walkers of one ensemble are not independent: the worse of what chains and ensembles say.
void heed_ensembles(const Eigen::MatrixXd& x, const std::vector<int>& group,
                    const Eigen::MatrixXd& pooled, Estimate& of) {
  const auto below = [&x](double limit) -> Eigen::MatrixXd {
    return (x.array() <= limit).cast<double>();
  };
  of.r_hat = std::max(of.r_hat, rank_r_hat(pooled));
  of.bulk_ess = std::min(of.bulk_ess, ensemble_ess(normal_scores(x), group));
  of.tail_ess = std::min(
      {of.tail_ess, ensemble_ess(below(of.q05), group), ensemble_ess(below(of.q95), group)});
}

}  // namespace

Estimate estimate(const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& x,
                  const std::vector<int>& group) {
  const Eigen::MatrixXd pooled = pool_groups(x, group);
  Estimate of{name, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
  if (x.size() == 0 || !x.allFinite()) return of;

  const Eigen::VectorXd rising = sorted(x);
  of.mean = x.mean();
  of.sd = std::sqrt((x.array() - of.mean).square().sum() / double(x.size() - 1));
  of.q05 = quantile(rising, 0.05);
  of.median = quantile(rising, 0.5);
  of.q95 = quantile(rising, 0.95);
  if (!can_be_judged(x)) of.sd = 0;  // alike: not even rounding of the mean
  if (x.rows() < 4 || of.sd == 0) return of;

  of.mcse_mean = mean_mcse(x, group);
  of.mcse_sd = sd_mcse(x);
  of.r_hat = rank_r_hat(x);
  of.bulk_ess = bulk_ess(x);
  of.tail_ess = tail_ess(x);
  if (pooled.cols() < x.cols()) heed_ensembles(x, group, pooled, of);
  return of;
}

}  // namespace thenar
