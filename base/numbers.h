#pragma once

/// Infinity, NaN, and maximum and minimum that propagate NaN.

#include <cmath>
#include <initializer_list>
#include <limits>

#include <Eigen/Core>

namespace thenar {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// std::max(x, NaN) is x: a check that collects its largest error with it would pass where an error
// is unknown. The functions below return NaN instead.

/// Returns the largest of two; NaN if either is.
[[nodiscard]] inline double max_or_nan(double a, double b) {
  return a >= b || std::isnan(a) ? a : b;
}

/// Returns the smallest of two; NaN if either is.
[[nodiscard]] inline double min_or_nan(double a, double b) {
  return a <= b || std::isnan(a) ? a : b;
}

/// Returns the largest of several; NaN if any is.
[[nodiscard]] inline double max_or_nan(std::initializer_list<double> all) {
  double most = *all.begin();
  for (const double each : all) most = max_or_nan(most, each);
  return most;
}

/// Returns the largest entry, which Eigen's maxCoeff() may miss beside NaN; NaN if any is.
template <typename Derived>
[[nodiscard]] double max_or_nan(const Eigen::DenseBase<Derived>& entries) {
  return entries.template maxCoeff<Eigen::PropagateNaN>();
}

}  // namespace thenar
