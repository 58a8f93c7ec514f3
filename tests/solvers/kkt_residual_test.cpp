// Tests for solvers/kkt_residual.cpp: conditions at points of a program solved by hand.

#include "solvers/kkt_residual.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// The point of  x + y <= 2,  0 <= x <= 1,  y free,  nearest to (3, 2):  minimise |p - (3, 2)|^2
/// / 2. At (1, 1) the gradient is (-2, -1), so the row's price is 1 and the bound's 1.
NonlinearProgram nearest_point() {
  NonlinearProgram program;
  program.lower = Vector2d(0, -kInfinity);
  program.upper = Vector2d(1, kInfinity);
  program.row_lower = VectorXd::Constant(1, -kInfinity);
  program.row_upper = VectorXd::Constant(1, 2);
  program.objective = [](const VectorXd& x) { return (x - Vector2d(3, 2)).squaredNorm() / 2; };
  program.gradient = [](const VectorXd& x) -> VectorXd { return x - Vector2d(3, 2); };
  program.constraints = [](const VectorXd& x) -> VectorXd {
    return VectorXd::Constant(1, x.sum());
  };
  program.jacobian = [](const VectorXd&) -> MatrixXd { return MatrixXd::Ones(1, 2); };
  return program;
}

TEST(KktResidual, IsZeroAtTheAnswer) {
  const KktResidual at =
      kkt_residual(nearest_point(), Vector2d(1, 1), VectorXd::Ones(1), Vector2d(1, 0));
  EXPECT_EQ(at.violation, 0);
  EXPECT_EQ(at.stationarity, 0);
  EXPECT_EQ(at.complementarity, 0);
}

// Without a price the gradient is left: (-2, -1) + (1, 1) = (-1, 0).
TEST(KktResidual, ShowsAMissingPriceInTheSlope) {
  const KktResidual at =
      kkt_residual(nearest_point(), Vector2d(1, 1), VectorXd::Ones(1), Vector2d::Zero());
  EXPECT_DOUBLE_EQ(at.stationarity, 1);
  EXPECT_EQ(at.complementarity, 0);
}

// Prices inside the bounds: 1 * |1 - 0.25| of the bound, 1 * |2 - 1| of the row.
TEST(KktResidual, SumsPricesTimesDistances) {
  const KktResidual at =
      kkt_residual(nearest_point(), Vector2d(0.25, 0.75), VectorXd::Ones(1), Vector2d(1, 0));
  EXPECT_DOUBLE_EQ(at.complementarity, 0.75 + 1);
}

// A price that pushes to an infinite bound is none, so that it shows in the slope alone: the price
// -5 of the row would push to its lower bound.
TEST(KktResidual, DropsPricesOfInfiniteBounds) {
  const KktResidual at =
      kkt_residual(nearest_point(), Vector2d(1, 1), VectorXd::Constant(1, -5), Vector2d(1, 0));
  EXPECT_EQ(at.complementarity, 0);
  EXPECT_DOUBLE_EQ(at.stationarity, 1);
}

// Over max(1, |bound|): x is 3 above 1, the row 2 above 2, which is 1 in parts of its bound.
TEST(KktResidual, ViolationIsRelativeToLargeBounds) {
  EXPECT_DOUBLE_EQ(violation(nearest_point(), Vector2d(4, 0)), 3);
  EXPECT_DOUBLE_EQ(violation(nearest_point(), Vector2d(1, 3)), 1);
  EXPECT_EQ(violation(nearest_point(), Vector2d(0.5, -9)), 0);
}

TEST(KktResidual, NanIsNeverWithinBounds) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(violation(nearest_point(), Vector2d(nan, 0))));
  const KktResidual at =
      kkt_residual(nearest_point(), Vector2d(nan, 0), VectorXd::Ones(1), Vector2d::Zero());
  EXPECT_TRUE(std::isnan(at.stationarity));
}

// |(-2, -1)| + |1| (1, 1) + |(1, 0)| = (4, 2).
TEST(KktResidual, ScaleOfRoundingIsTheSumOfSizes) {
  EXPECT_DOUBLE_EQ(
      gradient_scale(nearest_point(), Vector2d(1, 1), VectorXd::Ones(1), Vector2d(1, 0)), 4);
}

}  // namespace
}  // namespace thenar
