#include "solvers/sparse/sparse_cholesky.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

/// Laplace's matrix of a cube of n^3 points, plus a tenth on the diagonal.
struct Laplace {
  explicit Laplace(int n) {
    pattern.size = n * n * n;
    pattern.starts = {0};
    dense = Eigen::MatrixXd::Zero(pattern.size, pattern.size);
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const int at = (k * n + j) * n + i;
          add(at, at, 6.1);
          if (i + 1 < n) add(at + 1, at, -1);
          if (j + 1 < n) add(at + n, at, -1);
          if (k + 1 < n) add(at + n * n, at, -1);
          pattern.starts.push_back(static_cast<int>(pattern.rows.size()));
        }
  }
  void add(int row, int column, double value) {
    pattern.rows.push_back(row);
    values.push_back(value);
    dense(row, column) = dense(column, row) = value;
  }
  SymmetricPattern pattern;
  std::vector<double> values;
  Eigen::MatrixXd dense;
};

TEST(SparseCholesky, SolvesWhatItFactors) {
  const Laplace laplace(5);
  SparseCholesky factor(laplace.pattern);
  ASSERT_TRUE(factor.factor(laplace.values));
  Eigen::MatrixXd b(laplace.pattern.size, 2);
  b << Eigen::VectorXd::LinSpaced(b.rows(), -1, 1), Eigen::VectorXd::Ones(b.rows());
  EXPECT_LT((laplace.dense * factor.solve(b) - b).norm(), 1e-12);
}

TEST(SparseCholesky, SaysWhatIsNotPositiveDefiniteAndGoesOn) {
  Laplace laplace(4);
  SparseCholesky factor(laplace.pattern);
  const double good = laplace.values[0];
  laplace.values[0] = -1;
  EXPECT_FALSE(factor.factor(laplace.values));
  laplace.values[0] = good;
  ASSERT_TRUE(factor.factor(laplace.values));
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(laplace.pattern.size);
  EXPECT_LT((laplace.dense * factor.solve(b) - b).norm(), 1e-12);
}

TEST(SparseCholesky, NothingIsSolvedWithoutAFactor) {
  Laplace laplace(3);
  SparseCholesky factor(laplace.pattern);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(laplace.pattern.size);
  EXPECT_THROW((void)factor.solve(b), InputError);
  ASSERT_TRUE(factor.factor(laplace.values));
  EXPECT_THROW((void)factor.solve(b.head(5)), InputError);
  laplace.values[3] = NAN;
  EXPECT_FALSE(factor.factor(laplace.values));
  EXPECT_THROW((void)factor.solve(b), InputError);
}

TEST(SparseCholesky, PatternsThatAreNoLowerTriangleAreRefused) {
  EXPECT_THROW(SparseCholesky({2, {0, 1, 2}, {0, 0}}), InputError);  // column 1 above its diagonal
  EXPECT_THROW(SparseCholesky({2, {0, 2, 3}, {1, 0, 1}}), InputError);
  EXPECT_THROW(SparseCholesky({2, {0, 1}, {0}}), InputError);
}

}  // namespace
}  // namespace thenar
