// Potential scale reduction.

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "sampling/diagnostics/chain_parts.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/order_statistics.h"

namespace thenar {
namespace {

/// sqrt((B / W + n - 1) / n), between- and within-chain variance [Vehtari2021 eqs. 1-4].
double r_hat(const Eigen::MatrixXd& x) {
  const double n = double(x.rows()), m = double(x.cols());
  const Eigen::RowVectorXd mean = x.colwise().mean();
  const double between = n * (mean.array() - mean.mean()).square().sum() / (m - 1);
  const double within = (x.rowwise() - mean).squaredNorm() / ((n - 1) * m);
  return std::sqrt((between / within + n - 1) / n);
}

}  // namespace

double split_r_hat(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  const Eigen::MatrixXd halves = split_chains(x);
  return can_be_judged(x) ? r_hat(halves) : kNaN;
}

double rank_r_hat(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  const Eigen::MatrixXd halves = split_chains(x);
  if (!can_be_judged(halves)) return kNaN;
  const double bulk = r_hat(normal_scores(halves));

  // Folded about the median, chains of unequal spread differ in place.
  const Eigen::MatrixXd folded = (halves.array() - quantile(sorted(halves), 0.5)).abs();
  return can_be_judged(folded) ? std::max(bulk, r_hat(normal_scores(folded))) : bulk;
}

}  // namespace thenar
