// Tests for solvers/arrow_factor.cpp, against dense algebra on the same rows.

#include "solvers/arrow_factor.h"

#include <random>

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr ArrowLayout kLayout{3, 2, 4};

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::mt19937& rng) {
  return sample::normal(rows * columns, rng).reshaped(rows, columns);
}

/// Five rows a block, two for the shared coordinates alone; `prior` adds the identity.
std::vector<ArrowRows> random_rows(bool prior, std::mt19937& rng) {
  std::vector<ArrowRows> rows;
  for (int b = 0; b < kLayout.blocks; ++b)
    rows.push_back({b, random_matrix(5, kLayout.shared, rng), random_matrix(5, kLayout.own, rng)});
  rows.push_back({-1, random_matrix(2, kLayout.shared, rng), {}});
  if (!prior) return rows;
  rows.push_back({-1, MatrixXd::Identity(3, 3), {}});
  for (int b = 0; b < kLayout.blocks; ++b)
    rows.push_back({b, MatrixXd::Zero(2, 3), MatrixXd::Identity(2, 2)});
  return rows;
}

TEST(ArrowFactor, IsThatOfTheDenseJacobian) {
  std::mt19937 rng(1);
  const std::vector<ArrowRows> rows = random_rows(true, rng);
  const MatrixXd J = dense_rows(kLayout, rows), H = J.transpose() * J;
  const ArrowFactor factor(kLayout, rows);
  EXPECT_TRUE(matrix_near(factor.inverse(), H.inverse(), 1e-13));
  EXPECT_NEAR(factor.log_determinant(), std::log(H.determinant()), 1e-12);
  const VectorXd v = sample::normal(kLayout.size(), rng);
  EXPECT_NEAR(factor.squared_norm(v), (J * v).squaredNorm(), 1e-12);
  EXPECT_NEAR(factor.whiten(v).squaredNorm(), v.dot(H.inverse() * v), 1e-12);
  EXPECT_NEAR(factor.squared_norm(factor.unwhiten(v)), v.squaredNorm(), 1e-12 * v.squaredNorm());
  for (const ArrowRows& part : rows) {
    const MatrixXd W = factor.whiten(part), own = dense_rows(kLayout, {part});
    EXPECT_TRUE(matrix_near(W.transpose() * W, own * H.inverse() * own.transpose(), 1e-12));
  }
}

// A row 1e9 times as long as the others takes up all of one direction: the inverse has lost it, as
// 1e18 times 1e-18 in rounding, whitened rows have not.
TEST(ArrowFactor, KeepsTheLeverageOfLongRows) {
  std::mt19937 rng(4);
  std::vector<ArrowRows> rows = random_rows(true, rng);
  rows.front().shared.row(0) *= 1e9;
  if (rows.front().block >= 0) rows.front().own.row(0) *= 1e9;
  const ArrowFactor factor(kLayout, rows);
  for (const ArrowRows& part : rows)
    EXPECT_LE(factor.whiten(part).colwise().squaredNorm().maxCoeff(), 1 + 1e-12);
  EXPECT_NEAR(factor.whiten(rows.front()).col(0).squaredNorm(), 1, 1e-9);
}

TEST(ArrowFactor, TakesADenseProblemForSharedCoordinatesAlone) {
  std::mt19937 rng(2);
  const MatrixXd J = random_matrix(7, 4, rng);
  const ArrowFactor factor(ArrowLayout{4}, {{-1, J, {}}});
  EXPECT_TRUE(matrix_near(factor.inverse(), (J.transpose() * J).inverse(), 1e-12));
}

// A Jacobian of condition 1e9: of J'J no digit would be left, of the factor seven are.
TEST(ArrowFactor, KeepsDigitsThatNormalEquationsLose) {
  MatrixXd J = MatrixXd::Identity(2, 2);
  J(0, 1) = 1;
  J(1, 1) = 1e-9;
  const ArrowFactor factor(ArrowLayout{2}, {{-1, J, {}}});
  EXPECT_NEAR(factor.inverse()(1, 1), 1e18, 1e11);
}

/// A null space as orthonormal columns of all coordinates.
MatrixXd columns_of(const ArrowNullSpace& nulls) {
  MatrixXd N = nulls.coupled;
  for (int b = 0; b < kLayout.blocks; ++b) {
    const MatrixXd& alone = nulls.own[static_cast<std::size_t>(b)];
    const Eigen::Index before = N.cols();
    N.conservativeResize(kLayout.size(), before + alone.cols());
    N.rightCols(alone.cols()).setZero();
    N.block(kLayout.first_index(b), before, kLayout.own, alone.cols()) = alone;
  }
  return N;
}

TEST(ArrowNullSpace, IsThatOfTheDenseSingularValues) {
  std::mt19937 rng(3);
  std::vector<ArrowRows> rows = random_rows(false, rng);
  rows[1].own.col(1) = 3 * rows[1].own.col(0);  // one direction within a block
  rows[2].own.setZero();                        // a whole block
  // One shared direction that every block can answer by its own coordinates.
  for (ArrowRows& part : rows)
    if (part.block >= 0)
      part.shared.col(2) = part.own.col(0);
    else
      part.shared.col(2).setZero();
  const MatrixXd J = dense_rows(kLayout, rows);
  const auto rank = (J.jacobiSvd().singularValues().array() > 1e-9).count();
  const MatrixXd N = columns_of(arrow_null_space(kLayout, rows, 1e-9));
  EXPECT_EQ(N.cols(), kLayout.size() - rank);
  EXPECT_EQ(N.cols(), 4);
  EXPECT_TRUE(matrix_near(J * N, MatrixXd::Zero(J.rows(), N.cols()), 1e-12));
  EXPECT_TRUE(matrix_near(N.transpose() * N, MatrixXd::Identity(4, 4), 1e-13));
}

TEST(ArrowNullSpace, IsEverythingWithoutData) {
  EXPECT_EQ(columns_of(arrow_null_space(kLayout, {}, 1e-9)).cols(), kLayout.size());
}

TEST(ArrowFactor, HasTheBlocksOfTheDenseInverse) {
  std::mt19937 rng(4);
  const std::vector<ArrowRows> rows = random_rows(true, rng);
  const MatrixXd J = dense_rows(kLayout, rows), C = (J.transpose() * J).inverse();
  const ArrowMatrix blocks = ArrowFactor(kLayout, rows).inverse_blocks();
  EXPECT_TRUE(matrix_near(blocks.diagonal(), C.diagonal(), 1e-13));
  for (int b = -1; b < kLayout.blocks; ++b) {
    std::vector<int> on{0, 1, 2};
    if (b >= 0) on.insert(on.end(), {kLayout.first_index(b), kLayout.first_index(b) + 1});
    EXPECT_TRUE(matrix_near(blocks.block_entries(b), C(on, on), 1e-13)) << b;
  }
}

}  // namespace
}  // namespace thenar
