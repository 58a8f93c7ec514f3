// Tests for dynamics/contact/in_place_lu.cpp.

#include "dynamics/contact/in_place_lu.h"

#include <gtest/gtest.h>

#include <random>

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
