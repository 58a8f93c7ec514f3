// Tests for solvers/matrix_inequality.cpp: largest values that are eigenvalues.

#include "solvers/matrix_inequality.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "tests/matrix_near.h"

namespace thenar::internal {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A - y 1 >= 0: the largest y is the least eigenvalue of A.
MatrixInequality below_eigenvalues(const MatrixXd& A) {
  return {A, {{0, -MatrixXd::Identity(A.rows(), A.cols())}}};
}

Matrix3d sample_matrix() {
  Matrix3d A;
  A << 2, 0.5, -0.3, 0.5, 1, 0.2, -0.3, 0.2, 3;
  return A;
}

TEST(MatrixInequality, ValueIsTheSum) {
  const Matrix2d C = Matrix2d::Identity(), M = (Matrix2d() << 0, 1, 1, 0).finished();
  const MatrixInequality each{C, {{1, M}, {0, 2 * C}}};
  EXPECT_TRUE(matrix_near(evaluate(each, Eigen::Vector2d(3, -4)), 7 * C - 4 * M, 1e-15));
}

// What is a hair below the least eigenvalue is reached, a hair above it is not.
TEST(MatrixInequality, ReachesTheLeastEigenvalue) {
  const double least =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(sample_matrix()).eigenvalues().minCoeff();
  const std::vector<MatrixInequality> inequalities{below_eigenvalues(sample_matrix())};
  const VectorXd start = VectorXd::Zero(1);
  const MaximisedComponent below = maximise_component(inequalities, start, 0, least - 1e-6);
  EXPECT_TRUE(below.reached);
  EXPECT_GT(below.y(0), least - 1e-6);
  EXPECT_LT(below.y(0), least);  // strictly inside
  const MaximisedComponent above = maximise_component(inequalities, start, 0, least + 1e-6);
  EXPECT_FALSE(above.reached);
  EXPECT_LT(above.y(0), least);
}

// Of several inequalities the least of all eigenvalues counts.
TEST(MatrixInequality, TheTightestOfSeveralCounts) {
  const std::vector<MatrixInequality> both{below_eigenvalues(sample_matrix()),
                                           below_eigenvalues(0.3 * Matrix2d::Identity())};
  EXPECT_TRUE(maximise_component(both, VectorXd::Zero(1), 0, 0.3 - 1e-6).reached);
  EXPECT_FALSE(maximise_component(both, VectorXd::Zero(1), 0, 0.3 + 1e-6).reached);
}

// [1 x; x 1 - y] >= 0, |x| <= 1: the largest y is 1, at x = 0, wherever x begins.
TEST(MatrixInequality, OtherUnknownsGiveWay) {
  const Matrix2d X = (Matrix2d() << 0, 1, 1, 0).finished(),
                 Y = (Matrix2d() << 0, 0, 0, -1).finished();
  const std::vector<MatrixInequality> inequalities{{Matrix2d::Identity(), {{0, X}, {1, Y}}}};
  const MaximisedComponent found =
      maximise_component(inequalities, Eigen::Vector2d(0.9, 0), 1, 1 - 1e-6);
  ASSERT_TRUE(found.reached);
  EXPECT_LT(std::abs(found.y(0)), 1e-3);  // x^2 <= 1 - y
  EXPECT_FALSE(maximise_component(inequalities, Eigen::Vector2d(0.9, 0), 1, 1 + 1e-6).reached);
}

}  // namespace
}  // namespace thenar::internal
