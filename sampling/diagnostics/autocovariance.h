#pragma once

/// Autocovariance of a chain. The fence of Eigen's unsupported FFT.

#include <Eigen/Core>

namespace thenar {

/// Autocovariance of one chain at lags 0 .. lags - 1 (lags):
///   c(t) = 1/n sum_i (x_i - mean) (x_{i+t} - mean).
/// Divided by n at every lag, which keeps it positive definite [Geyer1992]. Few lags are summed one
/// by one, many by FFT.
/// @param x     one chain, finite (n)
/// @param lags  at most n
/// @return      [unit of x, squared]
[[nodiscard]] Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd>& x,
                                             Eigen::Index lags);

/// Returns the autocovariance at all lags (n).
[[nodiscard]] Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd>& x);

}  // namespace thenar
