#pragma once

/// Autocovariance of a chain. The only code that includes Eigen's unsupported FFT.

#include <Eigen/Core>

namespace thenar {

/// Computes the autocovariance of one chain at lags 0 .. lags - 1 (lags):
///   c(t) = 1/n sum_i (x_i - mean) (x_{i+t} - mean).
/// The division by n at every lag keeps it positive definite [Geyer1992]. Few lags are summed
/// directly, many by FFT.
/// @param x     one chain, finite (n)
/// @param lags  number of lags, at most n
/// @return      autocovariance [unit of x, squared]
[[nodiscard]] Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd>& x,
                                             Eigen::Index lags);

/// Computes the autocovariance at all lags (n).
[[nodiscard]] Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd>& x);

}  // namespace thenar
