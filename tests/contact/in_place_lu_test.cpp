// Tests for contact/in_place_lu.cpp.

#include "contact/in_place_lu.h"

#include <gtest/gtest.h>

#include <random>

#include "base/progress_parts.h"
#include "base/stop_scope.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(InPlaceLu, SolvesWhatItWasGiven) {
  std::mt19937 rng(1);
  std::normal_distribution<double> normal;
  InPlaceLu lu;
  for (const int n : {1, 2, 7, 40, 3}) {
    const MatrixXd R = MatrixXd::NullaryExpr(n, n, [&] { return normal(rng); });
    const VectorXd x = VectorXd::NullaryExpr(n, [&] { return normal(rng); });
    MatrixXd factors = R;
    VectorXd y = R * x;
    ASSERT_TRUE(lu.factor(factors));
    lu.solve(factors, y);
    EXPECT_TRUE(matrix_near(y, x, 1e-11));
  }
}

// Large systems are asked at every column whether to go on, small ones never.
TEST(InPlaceLu, IsStoppedAmidALargeSystem) {
  std::mt19937 rng(2);
  std::normal_distribution<double> normal;
  int asked = 0;
  Progress progress;
  progress.stop_requested = [&] { return ++asked > 100; };
  const StopScope scope(progress);
  InPlaceLu lu;
  MatrixXd large = MatrixXd::NullaryExpr(300, 300, [&] { return normal(rng); });
  EXPECT_THROW((void)lu.factor(large), Stopped);
  EXPECT_EQ(asked, 101);
  MatrixXd small = MatrixXd::NullaryExpr(40, 40, [&] { return normal(rng); });
  EXPECT_TRUE(lu.factor(small));
  EXPECT_EQ(asked, 101);
}

// [0 1; 1 0] has no pivot without an exchange of rows.
TEST(InPlaceLu, ExchangesRows) {
  MatrixXd R(2, 2);
  R << 0, 1, 1, 0;
  VectorXd y = Eigen::Vector2d(3, 4);
  InPlaceLu lu;
  ASSERT_TRUE(lu.factor(R));
  lu.solve(R, y);
  EXPECT_EQ(y, VectorXd(Eigen::Vector2d(4, 3)));
}

// Blocks that are one only by an entry far from the diagonal, and some that stand alone.
TEST(InPlaceLu, SolvesBlocksAlongTheDiagonal) {
  std::mt19937 rng(2);
  std::normal_distribution<double> normal;
  MatrixXd R = MatrixXd::Zero(12, 12);
  for (const auto& [begin, size] : {std::pair(0, 3), std::pair(3, 1), std::pair(4, 2)})
    R.block(begin, begin, size, size) =
        MatrixXd::NullaryExpr(size, size, [&] { return normal(rng); });
  R.bottomRightCorner(6, 6) = VectorXd::LinSpaced(6, 1, 2).asDiagonal();
  R(6, 11) = 3;   // ties rows 6 to 11
  R(8, 2) = 0.5;  // and 0 to 8
  for (const bool tied : {true, false}) {
    if (!tied) R(8, 2) = 0;
    const VectorXd x = VectorXd::NullaryExpr(12, [&] { return normal(rng); });
    MatrixXd factors = R;
    VectorXd y = R * x;
    InPlaceLu lu;
    ASSERT_TRUE(lu.factor(factors));
    lu.solve(factors, y);
    EXPECT_TRUE(matrix_near(y, x, 1e-12)) << tied;
  }
}

TEST(InPlaceLu, RefusesColumnsWithoutPivot) {
  MatrixXd R = MatrixXd::Zero(2, 2);
  R(0, 0) = 1;
  InPlaceLu lu;
  EXPECT_FALSE(lu.factor(R));
  MatrixXd bad = MatrixXd::Constant(1, 1, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(lu.factor(bad));
}

}  // namespace
}  // namespace thenar
