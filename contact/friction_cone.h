#pragma once

/// Projection onto the friction cone |t| <= mu n, and natural maps of cones and intervals.

#include <algorithm>

#include <Eigen/Core>

namespace thenar::internal {

/// Returns the point of the cone {|t| <= mu n} that is nearest to x = (n, t).
template <int Rows>
Eigen::Matrix<double, Rows, 1> nearest_in_cone(const Eigen::Matrix<double, Rows, 1>& x, double mu) {
  const double t = x.template tail<Rows - 1>().norm();
  if (t <= mu * x(0)) return x;
  // Project a point outside onto the nearest generator, or to 0 from inside the polar cone.
  const double n = (x(0) + mu * t) / (1 + mu * mu);
  Eigen::Matrix<double, Rows, 1> out = Eigen::Matrix<double, Rows, 1>::Zero();
  if (n <= 0) return out;
  out(0) = n;
  out.template tail<Rows - 1>() = (mu * n / t) * x.template tail<Rows - 1>();
  return out;
}

/// Returns the natural map  f - P_K(f - û)  with De Saxce's  û = u + mu |ut| n.
template <int Rows>
Eigen::Matrix<double, Rows, 1> cone_natural_map(const Eigen::Matrix<double, Rows, 1>& f,
                                                const Eigen::Matrix<double, Rows, 1>& u,
                                                double mu) {
  Eigen::Matrix<double, Rows, 1> x = f - u;
  x(0) -= mu * u.template tail<Rows - 1>().norm();
  return f - nearest_in_cone<Rows>(x, mu);
}

/// Returns the natural map  f - P(f - u)  of an interval lower <= f <= upper.
inline double interval_natural_map(double f, double u, double lower, double upper) {
  return f - std::clamp(f - u, lower, upper);
}

}  // namespace thenar::internal
