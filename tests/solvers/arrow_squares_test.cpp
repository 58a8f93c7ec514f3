// Tests for solvers/arrow_squares.cpp, against dense algebra.

#include "solvers/arrow_squares.h"

#include <random>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr ArrowLayout kWithPriors{3, 5, 4};
const std::vector<bool> kAllFree(static_cast<std::size_t>(kWithPriors.size()), true);

/// Rows over the shared coordinates and those of a block, among all coordinates.
MatrixXd spread(int block, const MatrixXd& J) {
  MatrixXd all = MatrixXd::Zero(J.rows(), kWithPriors.size());
  all.leftCols(kWithPriors.shared) = J.leftCols(kWithPriors.shared);
  if (block >= 0)
    all.middleCols(kWithPriors.first_index(block), kWithPriors.own) = J.rightCols(kWithPriors.own);
  return all;
}

MatrixXd normal_rows(int rows, int block, std::mt19937& rng) {
  const int columns = kWithPriors.shared + (block < 0 ? 0 : kWithPriors.own);
  return sample::normal(rows * columns, rng).reshaped(rows, columns);
}

/// Priors, rows added and a row taken away in each block, with and without blocks.
struct SampleSquares {
  ArrowSquares arrow{kWithPriors};
  MatrixXd dense = MatrixXd::Zero(kWithPriors.size(), kWithPriors.size());

  /// @param taken  size of the rows that are taken away
  SampleSquares(double taken, std::mt19937& rng) {
    for (int b = -1; b < kWithPriors.blocks; ++b) {
      // A row for each coordinate of its own, then two rows of all, and one that is taken.
      const int own = b < 0 ? kWithPriors.shared : kWithPriors.own;
      MatrixXd prior = MatrixXd::Zero(own, kWithPriors.shared + (b < 0 ? 0 : kWithPriors.own));
      prior.rightCols(own) =
          (sample::normal(own, rng).cwiseAbs().array() + 0.5).matrix().asDiagonal();
      add(b, prior);
      add(b, normal_rows(2, b, rng));
      const MatrixXd J = taken * normal_rows(1, b, rng);
      arrow.subtract(b, J);
      const MatrixXd all = spread(b, J);
      dense -= all.transpose() * all;
    }
  }

  void add(int block, const MatrixXd& J) {
    arrow.add(block, J);
    const MatrixXd all = spread(block, J);
    dense += all.transpose() * all;
  }
};

TEST(ArrowSquares, SolvesAsTheDenseMatrix) {
  std::mt19937 rng(1);
  const SampleSquares sample(0.1, rng);
  const VectorXd g = sample::normal(kWithPriors.size(), rng);
  const auto factor = ArrowSquaresFactor::factor(sample.arrow, kAllFree);
  ASSERT_TRUE(factor);
  EXPECT_TRUE(matrix_near(factor->solve(g), sample.dense.inverse() * g, 1e-12));
}

TEST(ArrowSquares, ScalesAllThatItHolds) {
  std::mt19937 rng(2);
  SampleSquares sample(0.1, rng);
  const VectorXd g = sample::normal(kWithPriors.size(), rng);
  sample.arrow.scale(3);
  const auto factor = ArrowSquaresFactor::factor(sample.arrow, kAllFree);
  ASSERT_TRUE(factor);
  EXPECT_TRUE(matrix_near(factor->solve(g), sample.dense.inverse() * g / 3, 1e-12));
}

TEST(ArrowSquares, LeavesHeldCoordinatesAlone) {
  std::mt19937 rng(3);
  const SampleSquares sample(0.1, rng);
  const VectorXd g = sample::normal(kWithPriors.size(), rng);
  std::vector<bool> some = kAllFree;
  std::vector<int> free;
  for (int i = 0; i < kWithPriors.size(); ++i) {
    some[static_cast<std::size_t>(i)] = i != 1 && i != 4 && i != 20;
    if (some[static_cast<std::size_t>(i)]) free.push_back(i);
  }
  const auto factor = ArrowSquaresFactor::factor(sample.arrow, some);
  ASSERT_TRUE(factor);
  VectorXd expected = VectorXd::Zero(kWithPriors.size());
  expected(free) = MatrixXd(sample.dense(free, free)).inverse() * VectorXd(g(free));
  EXPECT_TRUE(matrix_near(factor->solve(g), expected, 1e-12));
}

// A factor exists just where the smallest eigenvalue is positive, whichever rows make it negative.
TEST(ArrowSquares, RefusesWhatIsNotPositiveDefinite) {
  int positive = 0, not_positive = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 rng(seed);
    const SampleSquares sample(0.3, rng);
    const double least = sample.dense.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
    EXPECT_EQ(ArrowSquaresFactor::factor(sample.arrow, kAllFree).has_value(), least > 0) << seed;
    ++(least > 0 ? positive : not_positive);
  }
  EXPECT_GT(positive, 20);
  EXPECT_GT(not_positive, 20);
}

TEST(ArrowSquares, RefusesABlockWithoutAPrior) {
  ArrowSquares bare(kWithPriors);
  std::mt19937 rng(5);
  for (int b = -1; b < kWithPriors.blocks; ++b) bare.add(b, normal_rows(20, b, rng));
  EXPECT_FALSE(ArrowSquaresFactor::factor(bare, kAllFree));
}

}  // namespace
}  // namespace thenar
