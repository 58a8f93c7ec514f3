#include "dynamics/contact/in_place_lu.h"

#include <cmath>

namespace thenar {

bool InPlaceLu::factor(Eigen::Ref<Eigen::MatrixXd> R) {
  const Eigen::Index n = R.rows();
  pivots_.resize(static_cast<std::size_t>(n));
  for (Eigen::Index k = 0; k < n; ++k) {
    // The largest entry left in the column comes up.
    Eigen::Index at = 0;
    const double largest = R.col(k).tail(n - k).cwiseAbs().maxCoeff(&at);
    if (!(largest > 0) || !std::isfinite(largest)) return false;
    pivots_[static_cast<std::size_t>(k)] = k + at;
    if (at > 0) R.row(k).swap(R.row(k + at));

    // Its multiples leave the columns behind.
    const Eigen::Index rest = n - k - 1;
    R.col(k).tail(rest) /= R(k, k);
    for (Eigen::Index j = k + 1; j < n; ++j) R.col(j).tail(rest) -= R(k, j) * R.col(k).tail(rest);
  }
  return true;
}

void InPlaceLu::solve(const Eigen::Ref<const Eigen::MatrixXd>& factors,
                      Eigen::Ref<Eigen::VectorXd> y) const {
  const Eigen::Index n = factors.rows();
  for (Eigen::Index k = 0; k < n; ++k) std::swap(y(k), y(pivots_[static_cast<std::size_t>(k)]));
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index rest = n - k - 1;
    y.tail(rest) -= y(k) * factors.col(k).tail(rest);
  }
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    y(k) /= factors(k, k);
    y.head(k) -= y(k) * factors.col(k).head(k);
  }
}

}  // namespace thenar
