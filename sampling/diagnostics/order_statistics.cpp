#include "sampling/diagnostics/order_statistics.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/special_functions.h"

namespace thenar {

Eigen::MatrixXd average_ranks(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  // Sort all entries.
  const Eigen::MatrixXd dense = x;
  std::vector<std::pair<double, Eigen::Index>> order(dense.size());
  for (Eigen::Index i = 0; i < dense.size(); ++i) order[i] = {dense.data()[i], i};
  std::sort(order.begin(), order.end());

  Eigen::MatrixXd ranks(x.rows(), x.cols());
  for (std::size_t first = 0; first < order.size();) {
    // Ties share the mean of their ranks.
    std::size_t end = first;
    while (end < order.size() && order[end].first == order[first].first) ++end;
    for (std::size_t k = first; k < end; ++k)
      ranks.data()[order[k].second] = 0.5 * double(first + 1 + end);
    first = end;
  }
  return ranks;
}

Eigen::MatrixXd normal_scores(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  const double size = double(x.size()) + 0.25;
  return average_ranks(x).unaryExpr(
      [size](double rank) { return normal_quantile((rank - 0.375) / size); });
}

Eigen::VectorXd sorted(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  Eigen::VectorXd rising = x.reshaped();
  std::sort(rising.begin(), rising.end());
  return rising;
}

double quantile(const Eigen::Ref<const Eigen::VectorXd>& rising, double share) {
  require(rising.size() > 0, "a quantile needs draws, got none");
  require(share >= 0 && share <= 1, "a quantile's share lies in 0..1, got {}", share);
  const double at = share * double(rising.size() - 1);
  const auto below = Eigen::Index(std::floor(at));
  const Eigen::Index above = std::min(below + 1, rising.size() - 1);
  const double part = at - double(below);
  return part == 0 ? rising[below] : (1 - part) * rising[below] + part * rising[above];
}

}  // namespace thenar
