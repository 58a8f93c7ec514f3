// One quantity of a posterior.

#include <algorithm>
#include <cmath>
#include <limits>

#include "sampling/diagnostics/chain_parts.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {

Estimate estimate(const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& x,
                  const std::vector<int>& group) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Eigen::MatrixXd pooled = pool_groups(x, group);
  Estimate of{name, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
  if (x.size() == 0 || !x.allFinite()) return of;

  const Eigen::VectorXd rising = sorted(x);
  of.mean = x.mean();
  of.sd = std::sqrt((x.array() - of.mean).square().sum() / double(x.size() - 1));
  of.q05 = quantile(rising, 0.05);
  of.median = quantile(rising, 0.5);
  of.q95 = quantile(rising, 0.95);
  if (x.rows() < 4 || !can_be_judged(x)) return of;

  of.mcse_mean = mean_mcse(x);
  of.mcse_sd = sd_mcse(x);
  of.r_hat = rank_r_hat(x);
  if (pooled.cols() < x.cols()) of.r_hat = std::max(of.r_hat, rank_r_hat(pooled));
  of.bulk_ess = bulk_ess(x);
  of.tail_ess = tail_ess(x);
  return of;
}

}  // namespace thenar
