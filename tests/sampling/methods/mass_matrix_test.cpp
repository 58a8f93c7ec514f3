// Tests for sampling/methods/mass_matrix.cpp.

#include "sampling/methods/mass_matrix.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"

namespace thenar::internal {
namespace {

// [4 2; 2 5] = F F' with F = [2 0; 1 2], by hand.
const Eigen::Matrix2d kCovariance = (Eigen::Matrix2d() << 4, 2, 2, 5).finished();

TEST(MassMatrix, DriftsByItsFactorAndPullsByTheTranspose) {
  const MassMatrix metric(Metric::kDense, 2, kCovariance);
  Eigen::VectorXd x = Eigen::Vector2d(1, 1), slope(2);
  metric.drift(x, Eigen::Vector2d(3, -1), 0.5);  // F r = (6, 1)
  EXPECT_TRUE(matrix_near(x, Eigen::Vector2d(4, 1.5), 1e-15));
  metric.whiten_gradient(Eigen::Vector2d(3, -1), slope);  // F' g = (5, -2)
  EXPECT_TRUE(matrix_near(slope, Eigen::Vector2d(5, -2), 1e-15));
  EXPECT_TRUE(matrix_near(metric.covariance(), kCovariance, 1e-15));
}

TEST(MassMatrix, DiagonalTakesTheDiagonal) {
  const MassMatrix metric(Metric::kDiagonal, 2, kCovariance);
  Eigen::VectorXd x = Eigen::Vector2d(1, 1), slope(2);
  metric.drift(x, Eigen::Vector2d(3, -1), 0.5);
  EXPECT_TRUE(matrix_near(x, Eigen::Vector2d(4, 1 - std::sqrt(5) / 2), 1e-15));
  metric.whiten_gradient(Eigen::Vector2d(3, -1), slope);
  EXPECT_TRUE(matrix_near(slope, Eigen::Vector2d(6, -std::sqrt(5)), 1e-15));
}

TEST(MassMatrix, RefusesWhatIsNoCovariance) {
  const Eigen::Matrix2d indefinite = (Eigen::Matrix2d() << 1, 2, 2, 1).finished();
  const Eigen::Matrix2d skewed = (Eigen::Matrix2d() << 2, 1, 0, 2).finished();
  EXPECT_THROW(MassMatrix(Metric::kDense, 2, indefinite), InputError);
  EXPECT_THROW(MassMatrix(Metric::kDense, 2, skewed), InputError);
  EXPECT_THROW(MassMatrix(Metric::kDiagonal, 2, -kCovariance), InputError);
  EXPECT_THROW(MassMatrix(Metric::kDense, 3, kCovariance), InputError);
}

TEST(MassMatrix, KeepsItsOwnWhereAnotherIsRefused) {
  MassMatrix metric(Metric::kDense, 2, kCovariance);
  EXPECT_FALSE(metric.set(-kCovariance));
  EXPECT_FALSE(metric.set(kCovariance * std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(matrix_near(metric.covariance(), kCovariance, 1e-15));
}

// Points (0, 1), (2, 5), (4, 0) have mean (2, 2) and C = [4 -1; -1 7].
TEST(CovarianceEstimate, IsTheSampleCovarianceAndALittleOfTheOld) {
  for (const Metric metric : {Metric::kDense, Metric::kDiagonal}) {
    CovarianceEstimate estimate(metric, 2);
    for (const Eigen::Vector2d& x : {Eigen::Vector2d(0, 1), {2, 5}, {4, 0}}) estimate.add(x);
    Eigen::MatrixXd C = (Eigen::Matrix2d() << 4, -1, -1, 7).finished();
    Eigen::MatrixXd before = kCovariance;
    if (metric == Metric::kDiagonal) {
      C = C.diagonal().eval();
      before = before.diagonal().eval();
    }
    EXPECT_TRUE(matrix_near(estimate.shrunk(before), 3.0 / 8 * C + 5.0 / 8 * 1e-3 * before, 1e-14));
  }
}

}  // namespace
}  // namespace thenar::internal
