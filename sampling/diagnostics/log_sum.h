#pragma once

#include <cmath>

#include <Eigen/Core>

namespace thenar {

/// log sum_i exp(x_i), without overflow. @param x  at least one, none +inf or NaN (n)
[[nodiscard]] inline double log_sum(const Eigen::Ref<const Eigen::VectorXd>& x) {
  const double top = x.maxCoeff();
  return std::isfinite(top) ? top + std::log((x.array() - top).exp().sum()) : top;
}

}  // namespace thenar
