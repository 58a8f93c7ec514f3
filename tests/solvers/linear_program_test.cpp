// Tests for solvers/linear_program.cpp.

#include "solvers/linear_program.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "tests/matrix_near.h"
#include "tests/solvers/textbook_program.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using sample::textbook;

TEST(LinearProgram, FindsTextbookVertex) {
  const LinearResult result = solve(textbook());
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_TRUE(matrix_near(result.x, Vector2d(3, 1), 1e-12));
  EXPECT_NEAR(result.objective, 11, 1e-12);
}

TEST(LinearProgram, HoldsEqualities) {
  LinearProgram program = textbook();
  program.row_lower(0) = program.row_upper(0) = 2;
  EXPECT_TRUE(matrix_near(solve(program).x, Vector2d(2, 0), 1e-12));
}

TEST(LinearProgram, ReportsContradiction) {
  LinearProgram program = textbook();
  program.row_lower(0) = 5;  // against row_upper(1): x + 3y <= 6 and x <= 3 allow x + y <= 4
  program.row_upper(0) = 6;
  EXPECT_EQ(solve(program).status, Status::kInfeasible);
}

// By hand: x + y >= 5 less a third of x + 3y <= 6 is  2/3 x >= 3, but x <= 3 allows 2 only: the ray
// is (-1, 1/3), and the least sum of violations is 1, at (3, 1).
TEST(LinearProgram, ProvesAContradictionByAFarkasRay) {
  LinearProgram program = textbook();
  program.row_lower(0) = 5;
  program.row_upper(0) = 6;
  const LinearResult result = solve(program);
  ASSERT_EQ(result.ray.size(), 2);
  EXPECT_LE(result.ray.cwiseAbs().maxCoeff(), 1 + 1e-12);
  // y' A x is least at a corner of 0 <= x <= 3, y >= 0.
  const VectorXd slope = program.A.transpose() * result.ray;
  ASSERT_GE(slope(1), -1e-11) << "its bound is infinite";
  const double least = 3 * std::min(0.0, slope(0));
  double most = 0;
  for (int i = 0; i < 2; ++i)
    if (result.ray(i) != 0)
      most += result.ray(i) * (result.ray(i) > 0 ? program.row_upper(i) : program.row_lower(i));
  EXPECT_NEAR(least - most, 1, 1e-9);
  EXPECT_TRUE(std::isnan(result.objective));
  EXPECT_TRUE(result.x.isZero() && result.duals.isZero());
  EXPECT_LE(result.certificate.gap, 1e-11);
}

// x = 1 and x = 1 + 5e-10 at once: each x misses one of them by 2.5e-10 or more.
TEST(LinearProgram, StatesByHowMuchItMissesRowsThatItRelaxed) {
  LinearProgram program = textbook();
  program.A << 1, 0, 1, 0;
  program.row_lower = program.row_upper = Vector2d(1, 1 + 5e-10);
  program.upper(1) = 1;
  const LinearResult result = solve(program);
  ASSERT_EQ(result.status, Status::kSolved);
  EXPECT_NEAR(result.objective, 5, 2e-9);
  EXPECT_GE(result.certificate.violation, 2.4e-10);
  EXPECT_LE(result.certificate.violation, 5.1e-10);
}

TEST(LinearProgram, ReportsUnboundedGrowth) {
  LinearProgram program = textbook();
  program.row_upper.setConstant(kInfinity);
  EXPECT_EQ(solve(program).status, Status::kUnbounded);
}

// x + y >= 1 asks for a point that is not zero; y may grow for ever.
TEST(LinearProgram, ProvesGrowthByAPointAndARay) {
  LinearProgram program = textbook();
  program.row_lower(0) = 1;
  program.row_upper.setConstant(kInfinity);
  const LinearResult result = solve(program);
  ASSERT_EQ(result.status, Status::kUnbounded);
  ASSERT_EQ(result.x.size(), 2);
  EXPECT_GE(result.x.sum(), 1 - 1e-9);
  EXPECT_GE(result.x.minCoeff(), -1e-12);
  EXPECT_LE(result.x(0), 3 + 1e-12);
  EXPECT_TRUE(matrix_near(result.ray, Vector2d(0, 1), 1e-12));
  EXPECT_TRUE(std::isnan(result.objective));
}

// Unbounded in one variable and contradictory in another: there is no feasible point to grow from.
TEST(LinearProgram, CallsContradictoryAndUnboundedInfeasible) {
  LinearProgram program = textbook();
  program.A << 1, 0, 1, 0;
  program.row_lower = Vector2d(2, -kInfinity);
  program.row_upper = Vector2d(kInfinity, 1);
  EXPECT_EQ(solve(program).status, Status::kInfeasible);
}

TEST(LinearProgram, SolvesWithoutRows) {
  LinearProgram program = textbook();
  program.A.resize(0, 2);
  program.row_lower.resize(0);
  program.row_upper.resize(0);
  program.upper(1) = 7;
  EXPECT_TRUE(matrix_near(solve(program).x, Vector2d(3, 7), 1e-12));
}

// With the second row out of the way, the first is worth 2 and the bound of x is worth 1:
// 2 * 4 + 1 * 3 = 11 bounds the objective.
TEST(LinearProgram, StatesItsPricesAndNoGap) {
  LinearProgram program = textbook();
  program.row_upper(1) = 9;
  const LinearResult result = solve(program);
  EXPECT_TRUE(matrix_near(result.duals, Vector2d(2, 0), 1e-15));
  EXPECT_LE(result.certificate.gap, 1e-15);
  EXPECT_LE(result.certificate.violation, 1e-15);
  EXPECT_LE(result.certificate.dual_violation, 1e-15);
}

TEST(LinearProgram, UnitOfTheObjectiveDoesNotMatter) {
  for (const double unit : {1e-12, 1e12}) {
    LinearProgram program = textbook();
    program.row_upper(1) = 9;
    program.objective *= unit;
    const LinearResult result = solve(program);
    EXPECT_EQ(result.status, Status::kSolved);
    EXPECT_TRUE(matrix_near(result.duals, unit * Vector2d(2, 0), 1e-14 * unit));
    EXPECT_NEAR(result.objective, 11 * unit, 1e-14 * unit);
  }
}

// x + y = 1 and x + y = 1 + 1e-10 contradict each other within the rounding that rows may carry;
// 1e-8 apart they do not agree any more.
TEST(LinearProgram, RelaxesRowsThatRoundingSetsAtOdds) {
  LinearProgram program = textbook();
  program.A << 1, 1, 1, 1;
  program.row_lower = program.row_upper = Vector2d(1, 1 + 1e-10);
  const LinearResult result = solve(program);
  EXPECT_EQ(result.status, Status::kSolved);
  EXPECT_NEAR(result.objective, 3, 1e-9);
  program.row_lower(1) = program.row_upper(1) = 1 + 1e-8;
  EXPECT_EQ(solve(program).status, Status::kInfeasible);
}

TEST(LinearProgram, CrossedBoundsAreInfeasible) {
  LinearProgram program = textbook();
  program.lower(1) = 8;
  program.upper(1) = 7;
  const LinearResult result = solve(program);
  EXPECT_EQ(result.status, Status::kInfeasible);
  EXPECT_EQ(result.ray.size(), 0);
  EXPECT_TRUE(std::isnan(result.certificate.violation));
}

TEST(LinearProgram, PrintsNothing) {
  testing::internal::CaptureStdout();
  (void)solve(textbook());
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(LinearProgram, RefusesNaN) {
  LinearProgram program = textbook();
  program.upper(0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)solve(program), InputError);
}

}  // namespace
}  // namespace thenar
