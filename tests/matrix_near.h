#pragma once

/// Comparing matrices in tests: says which element is off, and by how much.

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <Eigen/Core>

namespace thenar {

/// Every element of `actual` within `tolerance` of `expected`; NaN is never near.
[[nodiscard]] inline testing::AssertionResult matrix_near(const Eigen::MatrixXd& actual,
                                                          const Eigen::MatrixXd& expected,
                                                          double tolerance) {
  if (actual.rows() != expected.rows() || actual.cols() != expected.cols())
    return testing::AssertionFailure()
           << fmt::format("shape is {} x {}, expected {} x {}", actual.rows(), actual.cols(),
                          expected.rows(), expected.cols());
  for (Eigen::Index i = 0; i < actual.rows(); ++i)
    for (Eigen::Index j = 0; j < actual.cols(); ++j)
      if (!(std::abs(actual(i, j) - expected(i, j)) <= tolerance))
        return testing::AssertionFailure() << fmt::format(
                   "element ({}, {}) is {:.17g}, expected {:.17g}, off by {:.3g} > {:.3g}", i, j,
                   actual(i, j), expected(i, j), std::abs(actual(i, j) - expected(i, j)),
                   tolerance);
  return testing::AssertionSuccess();
}

}  // namespace thenar
