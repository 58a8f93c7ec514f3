// Tests for solvers/arrow_matrix.cpp, against dense algebra.

#include "solvers/arrow_matrix.h"

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

constexpr ArrowLayout kArrow{3, 2, 4};

/// J'J of random rows that read one block each, with and without blocks.
struct SampleHessian {
  ArrowMatrix arrow{kArrow};
  MatrixXd dense = MatrixXd::Zero(kArrow.size(), kArrow.size());

  explicit SampleHessian(std::mt19937& rng) {
    for (int b = -1; b < kArrow.blocks; ++b) {
      const int own = b < 0 ? 0 : kArrow.own, columns = kArrow.shared + own;
      const MatrixXd J = sample::normal(6 * columns, rng).reshaped(6, columns);
      const MatrixXd part = J.transpose() * J;
      arrow.add(b, part);
      MatrixXd place = MatrixXd::Zero(columns, kArrow.size());
      place.topLeftCorner(kArrow.shared, kArrow.shared).setIdentity();
      if (b >= 0) place.block(kArrow.shared, kArrow.first(b), own, own).setIdentity();
      dense += place.transpose() * part * place;
    }
  }
};

const std::vector<bool> kAllFree(static_cast<std::size_t>(kArrow.size()), true);

TEST(ArrowCholesky, SolvesAsTheDenseMatrix) {
  std::mt19937 rng(1);
  const SampleHessian sample(rng);
  const VectorXd g = sample::normal(kArrow.size(), rng);
  const auto factor = ArrowCholesky::factor(sample.arrow, kAllFree);
  ASSERT_TRUE(factor);
  EXPECT_TRUE(matrix_near(factor->solve(g), sample.dense.inverse() * g, 1e-12));
}

TEST(ArrowMatrix, HasTheEntriesOfTheDenseOne) {
  std::mt19937 rng(4);
  const SampleHessian sample(rng);
  EXPECT_EQ(sample.arrow.diagonal(), VectorXd(sample.dense.diagonal()));
  for (int b = -1; b < kArrow.blocks; ++b) {
    std::vector<int> on{0, 1, 2};
    if (b >= 0) on.insert(on.end(), {kArrow.first(b), kArrow.first(b) + 1});
    EXPECT_EQ(sample.arrow.of(b), MatrixXd(sample.dense(on, on)));
  }
}

TEST(ArrowCholesky, LeavesHeldCoordinatesAlone) {
  std::mt19937 rng(2);
  const SampleHessian sample(rng);
  const VectorXd g = sample::normal(kArrow.size(), rng);
  std::vector<bool> some = kAllFree;
  std::vector<int> free;
  for (int i = 0; i < kArrow.size(); ++i) {
    some[static_cast<std::size_t>(i)] = i != 1 && i != 4 && i != 10;
    if (some[static_cast<std::size_t>(i)]) free.push_back(i);
  }
  const auto factor = ArrowCholesky::factor(sample.arrow, some);
  ASSERT_TRUE(factor);
  VectorXd expected = VectorXd::Zero(kArrow.size());
  expected(free) = MatrixXd(sample.dense(free, free)).inverse() * VectorXd(g(free));
  EXPECT_TRUE(matrix_near(factor->solve(g), expected, 1e-12));
}

// Taking out more than the smallest eigenvalue has must show, in a block or among what is shared.
TEST(ArrowCholesky, RefusesWhatIsNotPositiveDefinite) {
  std::mt19937 rng(3);
  const SampleHessian sample(rng);
  ArrowMatrix one(kArrow);
  one.shared.setIdentity();
  for (MatrixXd& own : one.own) own.setIdentity();
  const double least = sample.dense.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
  ArrowMatrix above = sample.arrow, below = sample.arrow;
  above.add(one, -0.99 * least);
  below.add(one, -1.01 * least);
  EXPECT_TRUE(ArrowCholesky::factor(above, kAllFree));
  EXPECT_FALSE(ArrowCholesky::factor(below, kAllFree));
}

}  // namespace
}  // namespace thenar
