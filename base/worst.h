#pragma once

/// The largest and the smallest of numbers, NaN where one of them is: std::max(x, NaN) is x, so
/// that a check which adds up its worst error so would pass where nothing is known.

#include <cmath>
#include <initializer_list>

#include <Eigen/Core>

namespace thenar {

/// The largest of two; NaN if either is.
[[nodiscard]] inline double largest_or_nan(double a, double b) {
  return a >= b || std::isnan(a) ? a : b;
}

/// The smallest of two; NaN if either is.
[[nodiscard]] inline double smallest_or_nan(double a, double b) {
  return a <= b || std::isnan(a) ? a : b;
}

/// The largest of several; NaN if any is.
[[nodiscard]] inline double largest_or_nan(std::initializer_list<double> all) {
  double most = *all.begin();
  for (const double each : all) most = largest_or_nan(most, each);
  return most;
}

/// The largest entry, which Eigen's maxCoeff() may miss beside NaN; NaN if any is.
template <typename Derived>
[[nodiscard]] double largest_or_nan(const Eigen::DenseBase<Derived>& entries) {
  return entries.template maxCoeff<Eigen::PropagateNaN>();
}

}  // namespace thenar
