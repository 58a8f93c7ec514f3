// Tests for solvers/nonlinear_program.cpp.

#include "solvers/nonlinear_program.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "solvers/kkt_residual.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kClose = 1e-7;  // what limited-memory steps reach at the default tolerance

// Distance to (2, 1) squared, without bounds.
NonlinearProgram nearest_to_2_1() {
  NonlinearProgram program;
  program.lower = VectorXd::Constant(2, -kInfinity);
  program.upper = VectorXd::Constant(2, kInfinity);
  program.objective = [](const VectorXd& x) { return (x - Vector2d(2, 1)).squaredNorm(); };
  program.gradient = [](const VectorXd& x) -> VectorXd { return 2 * (x - Vector2d(2, 1)); };
  return program;
}

// The same, on the disc of radius 1: the optimum is (2, 1) / sqrt(5).
NonlinearProgram nearest_in_disc() {
  NonlinearProgram program = nearest_to_2_1();
  program.row_lower = VectorXd::Constant(1, -kInfinity);
  program.row_upper = VectorXd::Constant(1, 1.0);
  program.constraints = [](const VectorXd& x) -> VectorXd {
    return VectorXd::Constant(1, x.squaredNorm());
  };
  program.jacobian = [](const VectorXd& x) -> MatrixXd { return 2 * x.transpose(); };
  return program;
}

TEST(NonlinearProgram, FindsFreeMinimum) {
  const NonlinearResult result = solve_ipopt(nearest_to_2_1(), Vector2d::Zero());
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_TRUE(matrix_near(result.x, Vector2d(2, 1), kClose));
}

TEST(NonlinearProgram, StopsAtBounds) {
  NonlinearProgram program = nearest_to_2_1();
  program.upper = Vector2d(1, kInfinity);
  EXPECT_TRUE(matrix_near(solve_ipopt(program, Vector2d::Zero()).x, Vector2d(1, 1), kClose));
}

TEST(NonlinearProgram, ObeysNonlinearConstraint) {
  const NonlinearResult result = solve_ipopt(nearest_in_disc(), Vector2d(0.1, 0.1));
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_TRUE(matrix_near(result.x, Vector2d(2, 1) / std::sqrt(5.0), kClose));
}

TEST(NonlinearProgram, ExactHessianFindsTheSamePoint) {
  NonlinearProgram program = nearest_in_disc();
  program.hessian = [](const VectorXd&, double factor, const VectorXd& multipliers) -> MatrixXd {
    return 2 * (factor + multipliers(0)) * MatrixXd::Identity(2, 2);
  };
  const NonlinearResult result = solve_ipopt(program, Vector2d(0.1, 0.1));
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_TRUE(matrix_near(result.x, Vector2d(2, 1) / std::sqrt(5.0), kClose));
}

// At the optimum x* = (2, 1) / sqrt(5) the slope 2 (x* - (2, 1)) is met by y 2 x* with y = sqrt(5)
// - 1.
TEST(KktResidual, VanishesAtTheOptimumAndNowhereElse) {
  const Vector2d best = Vector2d(2, 1) / std::sqrt(5.0);
  const VectorXd y = VectorXd::Constant(1, std::sqrt(5.0) - 1), none = Vector2d::Zero();
  const KktResidual at = kkt_residual(nearest_in_disc(), best, y, none);
  EXPECT_LT(at.violation, 1e-15);
  EXPECT_LT(at.stationarity, 1e-15);
  EXPECT_LT(at.complementarity, 1e-15);
  // At zero the slope is (-4, -2); the price of the disc stands 1 away from its bound.
  const KktResidual off = kkt_residual(nearest_in_disc(), none, y, none);
  EXPECT_EQ(off.stationarity, 4);
  EXPECT_NEAR(off.complementarity, y(0), 1e-15);
  EXPECT_NEAR(kkt_residual(nearest_in_disc(), Vector2d(2, 0), y, none).violation, 3, 1e-15);
}

TEST(KktResidual, SeesThatAVariableIsNotANumber) {
  NonlinearProgram program = nearest_in_disc();
  program.constraints = [](const VectorXd&) { return VectorXd::Zero(1); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(violation(program, Vector2d(0, nan))));
}

// A price that pushes to where there is no bound cannot excuse a slope.
TEST(KktResidual, PricesOfInfiniteBoundsExcuseNothing) {
  const KktResidual at =
      kkt_residual(nearest_to_2_1(), Vector2d(0, 1), VectorXd(0), Vector2d(4, 0));
  EXPECT_EQ(at.stationarity, 4);
  EXPECT_EQ(at.complementarity, 0);
}

TEST(NonlinearProgram, StatesWhatIsLeft) {
  const NonlinearResult result = solve_ipopt(nearest_in_disc(), Vector2d(0.1, 0.1));
  EXPECT_LT(result.kkt_residual.violation, 1e-9);
  EXPECT_LT(result.kkt_residual.stationarity, 1e-6);
  EXPECT_LT(result.kkt_residual.complementarity, 1e-9);
}

// Where nothing at all may be left, even Ipopt's best second run is refused.
TEST(NonlinearProgram, RefusesPointsWhoseConditionsFail) {
  NonlinearOptions strict;
  strict.kkt_tolerance = 0;
  strict.acceptable_tolerance = 0;
  const NonlinearResult result = solve_ipopt(nearest_in_disc(), Vector2d(0.1, 0.1), strict);
  EXPECT_EQ(result.status, Status::kStalled);
  EXPECT_NE(result.message.find("first-order conditions do not hold"), std::string::npos);
}

// The slope of (x - 2)^4 + y^2 is 4e9 at the start: what Ipopt leaves of it at a loose tolerance is
// a small part of that, and no optimum.
TEST(NonlinearProgram, SteepStartsExcuseNoSlopeAtTheEnd) {
  NonlinearProgram program = nearest_to_2_1();
  program.objective = [](const VectorXd& x) { return std::pow(x(0) - 2, 4) + x(1) * x(1); };
  program.gradient = [](const VectorXd& x) -> VectorXd {
    return Vector2d(4 * std::pow(x(0) - 2, 3), 2 * x(1));
  };
  NonlinearOptions loose;
  loose.tolerance = 1e-5;
  loose.acceptable_tolerance = 1e-8;
  const NonlinearResult result = solve_ipopt(program, Vector2d(1002, 0), loose);
  const double left = program.gradient(result.x).cwiseAbs().maxCoeff();
  EXPECT_TRUE(result.status == Status::kStalled || left <= 1e-6)
      << result.message << ", slope " << left;
}

// Nothing to vary and nothing obeyed.
TEST(NonlinearProgram, ContradictionWithoutVariablesIsInfeasible) {
  NonlinearProgram program = nearest_in_disc();
  program.lower.resize(0);
  program.upper.resize(0);
  program.row_upper(0) = -1;
  program.objective = [](const VectorXd&) { return 0.0; };
  EXPECT_EQ(solve_ipopt(program, VectorXd(0)).status, Status::kInfeasible);
}

TEST(NonlinearProgram, ReportsContradiction) {
  NonlinearProgram program = nearest_in_disc();
  program.row_upper(0) = -1;  // no square is negative
  EXPECT_EQ(solve_ipopt(program, Vector2d(0.1, 0.1)).status, Status::kInfeasible);
}

TEST(NonlinearProgram, ReportsIterationLimit) {
  NonlinearOptions options;
  options.max_iterations = 1;
  const NonlinearResult result = solve_ipopt(nearest_in_disc(), Vector2d(0.1, 0.1), options);
  EXPECT_EQ(result.status, Status::kLimit);
  EXPECT_EQ(result.message, "iteration limit reached");
}

TEST(NonlinearProgram, PassesOnAnExceptionOfTheCaller) {
  NonlinearProgram program = nearest_to_2_1();
  program.gradient = [](const VectorXd&) -> VectorXd { throw std::range_error("mine"); };
  EXPECT_THROW((void)solve_ipopt(program, Vector2d::Zero()), std::range_error);
}

TEST(NonlinearProgram, PrintsNothing) {
  testing::internal::CaptureStdout();
  (void)solve_ipopt(nearest_in_disc(), Vector2d(0.1, 0.1));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(NonlinearProgram, RefusesNaNStart) {
  EXPECT_THROW((void)solve_ipopt(nearest_to_2_1(), Vector2d(std::nan(""), 0)), InputError);
}

}  // namespace
}  // namespace thenar
