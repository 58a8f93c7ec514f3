#pragma once

/// Distribution functions, from Eigen's unsupported special functions (those of Cephes), which only
/// this pair of files includes.

namespace thenar {

/// Half width of a normal 95 % interval, normal_quantile(0.975) [sds].
inline constexpr double kNormal95HalfWidth = 1.959963984540054;

/// Returns z with P(Z <= z) = p, Z standard normal; -inf at 0, inf at 1, NaN beyond.
[[nodiscard]] double normal_quantile(double p);

/// Returns P(X > x), X chi-square with `dof` degrees of freedom.
[[nodiscard]] double chi_square_tail(double x, double dof);

/// Returns x with P(X <= x) = p, X ~ Beta(a, b), by bisection to full accuracy. @param p  in (0, 1)
[[nodiscard]] double beta_quantile(double p, double a, double b);

}  // namespace thenar
