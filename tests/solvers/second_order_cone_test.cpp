// Tests for solvers/second_order_cone.cpp: the algebra by its laws.

#include "solvers/second_order_cone.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/matrix_near.h"

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const std::vector<int> kCones{1, 3, 2, 4};  // rows of each, ten in all

/// A point well inside of all cones.
VectorXd inside_cones(std::mt19937& rng) {
  std::normal_distribution<double> normal;
  VectorXd out(10);
  int start = 0;
  for (const int rows : kCones) {
    for (int i = 1; i < rows; ++i) out[start + i] = normal(rng);
    out[start] = out.segment(start + 1, rows - 1).norm() + 0.1 + std::abs(normal(rng));
    start += rows;
  }
  return out;
}

// (1, 0, ..) of each cone leaves everything as it is; the quotient undoes the product.
TEST(SecondOrderCone, QuotientUndoesTheProduct) {
  std::mt19937 rng(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    const VectorXd u = inside_cones(rng),
                   v = VectorXd::NullaryExpr(10, [&] { return normal(rng); });
    EXPECT_TRUE(matrix_near(cone_product(kCones, cone_identity(kCones), v), v, 1e-14));
    EXPECT_TRUE(matrix_near(cone_product(kCones, u, v), cone_product(kCones, v, u), 1e-14));
    EXPECT_TRUE(matrix_near(cone_quotient(kCones, u, cone_product(kCones, u, v)), v, 1e-11));
  }
}

TEST(SecondOrderCone, ProductByHand) {
  const Eigen::Vector3d u(3, 1, 2), v(2, -1, 1);
  EXPECT_TRUE(matrix_near(cone_product({3}, u, v), Eigen::Vector3d(7, -1, 7), 1e-14));
}

// From (2, 0) along (0, 1) the cone ends after 2, along (-1, 1) after 1; along (1, 0) never.
TEST(SecondOrderCone, StepsEndAtTheBoundary) {
  const Eigen::Vector2d u(2, 0);
  EXPECT_NEAR(step_to_cone({2}, u, Eigen::Vector2d(0, 1), 10), 2, 1e-14);
  EXPECT_NEAR(step_to_cone({2}, u, Eigen::Vector2d(-1, 1), 10), 1, 1e-14);
  EXPECT_EQ(step_to_cone({2}, u, Eigen::Vector2d(1, 0), 10), 10);
  EXPECT_EQ(step_to_cone({2}, u, Eigen::Vector2d(0, 1), 0.5), 0.5);
  // Of several cones the nearest boundary counts.
  EXPECT_NEAR(step_to_cone({1, 2}, Eigen::Vector3d(1, 2, 0), Eigen::Vector3d(-2, 0, 1), 10), 0.5,
              1e-14);
}

// W z = W^-1 s, W is symmetric and its inverse is one; s = z gives W = 1.
TEST(SecondOrderCone, ScalingTakesBothToOnePoint) {
  std::mt19937 rng(2);
  for (int trial = 0; trial < 50; ++trial) {
    const VectorXd s = inside_cones(rng), z = inside_cones(rng);
    const ConeScaling W(kCones, s, z);
    EXPECT_TRUE(matrix_near(W.times(z), W.divide(s), 1e-9));
    const MatrixXd matrix = W.times(MatrixXd::Identity(10, 10));
    EXPECT_TRUE(matrix_near(matrix, matrix.transpose(), 1e-12 * matrix.cwiseAbs().maxCoeff()));
    EXPECT_TRUE(matrix_near(W.divide(matrix), MatrixXd::Identity(10, 10), 1e-8));
    const ConeScaling same(kCones, s, s);
    EXPECT_TRUE(
        matrix_near(same.times(MatrixXd::Identity(10, 10)), MatrixXd::Identity(10, 10), 1e-8));
  }
}

}  // namespace
}  // namespace thenar::internal
