// Tests for solvers/bounded_least_squares.cpp.

#include "solvers/bounded_least_squares.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/numbers.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

const BoundedFitOptions kFine{1e-14, 0, 10, 200};

BoundedFit fit_of(std::function<FitResiduals(const VectorXd& x, Sensitivities slopes)> residuals) {
  return {Vector2d(-kInfinity, -kInfinity), Vector2d(kInfinity, kInfinity), Vector2d(0, 0),
          std::move(residuals)};
}

/// r = x - a.
BoundedFit distance_to(const Vector2d& a) {
  return fit_of([a](const VectorXd& x, Sensitivities) {
    return FitResiduals{true, x - a, MatrixXd::Identity(2, 2)};
  });
}

// H = [2 1; 1 2], g = (-6, 0), 0 <= d: with d2 at its bound 0, 4 d1 = 6, and the slope by d2 is 3.
TEST(BoundedQuadratic, StopsAtABound) {
  Matrix2d H;
  H << 2, 1, 1, 2;
  const VectorXd d =
      bounded_quadratic(H, Vector2d(-6, 0), Vector2d(0, 0), Vector2d(kInfinity, kInfinity));
  EXPECT_TRUE(matrix_near(d, Vector2d(1.5, 0), 1e-8));
}

// The same in a box of 2: at its minimum (1.5, 0) nothing is left; at (0, 0), where the function is
// 0 and its minimum -4.5, the tangent plane falls by 12.
TEST(BoundedQuadratic, GapBoundsWhatIsMissing) {
  Matrix2d H;
  H << 2, 1, 1, 2;
  const Vector2d g(-6, 0), low(0, 0), high(2, 2);
  EXPECT_EQ(quadratic_gap(H, g, low, high, Vector2d(1.5, 0)), 0);
  EXPECT_EQ(quadratic_gap(H, g, low, high, Vector2d(0, 0)), 12);
  const VectorXd found = bounded_quadratic(H, g, low, high);
  EXPECT_LT(quadratic_gap(H, g, low, high, found), 1e-7);
}

// Each unknown alone: minimise (x - a)^2 + p x over x >= 0, so x = max(0, a - p / 2).
TEST(FitBounded, ShrinksByHalfThePriceAndStopsAtZero) {
  BoundedFit fit = distance_to({3, 0.4});
  fit.lower = Vector2d(0, 0);
  fit.price = Vector2d(1, 1);
  const BoundedFitResult found = bounded_least_squares(fit, Vector2d(1, 1), kFine);
  EXPECT_TRUE(found.converged);
  EXPECT_TRUE(matrix_near(found.x, Vector2d(2.5, 0), 1e-7));
}

TEST(FitBounded, MovesTheStartBetweenTheBounds) {
  BoundedFit fit = distance_to({9, 9});
  fit.upper = Vector2d(1, 2);
  EXPECT_TRUE(matrix_near(bounded_least_squares(fit, Vector2d(5, 5), kFine).x, Vector2d(1, 2), 0));
}

// Rosenbrock's valley as least squares: r = (10 (y - x^2), 1 - x), minimum at (1, 1).
TEST(FitBounded, FollowsACurvedValley) {
  const BoundedFit fit = fit_of([](const VectorXd& x, Sensitivities) {
    Matrix2d J;
    J << -20 * x(0), 10, -1, 0;
    return FitResiduals{true, Vector2d(10 * (x(1) - x(0) * x(0)), 1 - x(0)), J};
  });
  EXPECT_TRUE(
      matrix_near(bounded_least_squares(fit, Vector2d(-1.2, 1), kFine).x, Vector2d(1, 1), 1e-6));
}

// sqrt(x) - 1 has no value below 0, where a full step from x = 9 by its slope 1/6 would end.
TEST(FitBounded, StepsBackFromWhereTheModelHasNoAnswer) {
  const BoundedFit fit = fit_of([](const VectorXd& x, Sensitivities) {
    if (x(0) < 0) return FitResiduals{};
    Matrix2d J = Matrix2d::Zero();
    J(0, 0) = 0.5 / std::sqrt(x(0));
    J(1, 1) = 1;
    return FitResiduals{true, Vector2d(std::sqrt(x(0)) - 1, x(1)), J};
  });
  const BoundedFitResult found = bounded_least_squares(fit, Vector2d(9, 0), {1e-14, 0, 100, 200});
  EXPECT_NEAR(found.x(0), 1, 1e-6);
}

TEST(FitBounded, SaysWhenTheStartHasNoAnswer) {
  const BoundedFit fit = fit_of([](const VectorXd&, Sensitivities) { return FitResiduals{}; });
  EXPECT_FALSE(bounded_least_squares(fit, Vector2d(0, 0)).possible);
}

}  // namespace
}  // namespace thenar
