#pragma once

/// Comparison of matrices that names the element, both values and the tolerance.

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Core>

namespace thenar {

/// True if shapes agree and every |actual - expected| <= tolerance.
template <typename A, typename B>
[[nodiscard]] testing::AssertionResult matrix_near(const Eigen::MatrixBase<A>& actual,
                                                   const Eigen::MatrixBase<B>& expected,
                                                   double tolerance) {
  if (actual.rows() != expected.rows() || actual.cols() != expected.cols())
    return testing::AssertionFailure()
           << "shape " << actual.rows() << " x " << actual.cols() << ", expected "
           << expected.rows() << " x " << expected.cols();
  const Eigen::MatrixXd a = actual, b = expected;
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      if (!(std::abs(a(i, j) - b(i, j)) <= tolerance))
        return testing::AssertionFailure() << "element (" << i << ", " << j << ") is " << a(i, j)
                                           << ", expected " << b(i, j) << " within " << tolerance;
  return testing::AssertionSuccess();
}

}  // namespace thenar
