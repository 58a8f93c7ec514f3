#pragma once

/// How a series resembles itself some steps later. The one fence of Eigen's unsupported FFT.

#include <Eigen/Core>

namespace thenar {

/// Autocovariance of one chain at lags 0 .. n - 1, by FFT (n):
///   c(t) = 1/n sum_i (x_i - mean) (x_{i+t} - mean).
/// Divided by n at every lag, which keeps it positive definite [Geyer1992].
/// @param x  one chain, finite (n)
/// @return   [unit of x, squared]
[[nodiscard]] Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd>& x);

}  // namespace thenar
