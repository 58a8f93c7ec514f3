// Tests for posterior/mode_curvature.cpp: with blocks and without, against dense algebra.

#include "posterior/mode_curvature.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A vector of the spread for every standard normal one: A with A A' = (J'J)^-1.
MatrixXd root_of(const ModeCurvature& curvature, Eigen::Index n) {
  MatrixXd A(n, n);
  for (Eigen::Index i = 0; i < n; ++i) A.col(i) = curvature.transform_normal(VectorXd::Unit(n, i));
  return A;
}

TEST(ModeCurvature, IsThatOfTheDenseJacobianWithAndWithoutBlocks) {
  const FitProblem problem = sample::noisy_copies(2);
  LeastSquares blocks = least_squares(problem);
  const Eigen::Index n = problem.size();
  // One coordinate of all, and one of each specimen, held.
  std::vector<Eigen::Index> held{3, blocks.layout.first_index(0) + 1,
                                 blocks.layout.first_index(1) + 2},
      free;
  for (const Eigen::Index i : held) blocks.lower[i] = blocks.upper[i] = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    if (std::count(held.begin(), held.end(), i) == 0) free.push_back(i);
  LeastSquares whole = blocks;
  whole.parts.clear();

  const VectorXd z = VectorXd::Zero(n);
  const MatrixXd J = whole.residuals(z, WithJacobian::kYes).J(Eigen::all, free);
  const MatrixXd H = J.transpose() * J;
  MatrixXd C = MatrixXd::Zero(n, n);
  C(free, free) = MatrixXd(H.inverse());
  std::mt19937 rng(1);
  VectorXd apart = VectorXd::Zero(n);
  apart(free) = sample::normal(static_cast<Eigen::Index>(free.size()), rng);
  for (const LeastSquares* of : {&blocks, &whole}) {
    const ModeCurvature curvature(*of, z);
    EXPECT_TRUE(matrix_near(curvature.covariance(), C, 1e-9));
    const MatrixXd A = root_of(curvature, n);
    EXPECT_TRUE(matrix_near(A * A.transpose(), C, 1e-9));
    EXPECT_TRUE(A(held, Eigen::all).isZero(0));
    EXPECT_NEAR(curvature.squared_norm(apart), (J * apart(free)).squaredNorm(),
                1e-9 * (J * apart(free)).squaredNorm());
    EXPECT_NEAR(curvature.log_determinant(), H.ldlt().vectorD().array().log().sum(), 1e-6);
  }
}

}  // namespace
}  // namespace thenar
