// Tests for sampling/methods/laplace_covariance.cpp.

#include "sampling/methods/laplace_covariance.h"

#include <limits>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "tests/matrix_near.h"
#include "tests/sampling/known_posteriors.h"

namespace thenar {
namespace {

/// log p = -1/2 x' P x.
sample::FunctionTarget quadratic(const Eigen::MatrixXd& P) {
  return {static_cast<int>(P.rows()), [P](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
            gradient = -P * x;
            return -0.5 * x.dot(P * x);
          }};
}

TEST(LaplaceCovariance, OfANormalDensityIsItsCovariance) {
  const Eigen::Matrix2d P = (Eigen::Matrix2d() << 4, 1, 1, 2).finished();
  EXPECT_TRUE(
      matrix_near(laplace_covariance(quadratic(P), Eigen::Vector2d(0.3, -2)), P.inverse(), 1e-9));
}

// A saddle counts by the size of its curvatures, and flat directions by a twentieth.
TEST(LaplaceCovariance, IsPositiveWhereTheDensityIsNoPeak) {
  const Eigen::Matrix3d P = Eigen::Vector3d(2, -5, 1e-3).asDiagonal();
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.5, 0.2, 20).asDiagonal();
  EXPECT_TRUE(
      matrix_near(laplace_covariance(quadratic(P), Eigen::Vector3d(1, 1, 1)), expected, 1e-7));
}

TEST(LaplaceCovariance, IsTheIdentityWithoutFiniteGradients) {
  const sample::FunctionTarget broken(2, [](const Eigen::VectorXd&, Eigen::VectorXd& gradient) {
    gradient.setConstant(std::numeric_limits<double>::quiet_NaN());
    return 0.0;
  });
  EXPECT_EQ(laplace_covariance(broken, Eigen::Vector2d(1, 1)), Eigen::MatrixXd::Identity(2, 2));
}

}  // namespace
}  // namespace thenar
