// Tests for solvers/bound_prices.cpp.

#include "solvers/bound_prices.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// maximise c' x  subject to  A x <= b,  0 <= x <= u.
LinearProgram program_of(const Eigen::VectorXd& c, const Eigen::MatrixXd& A,
                         const Eigen::VectorXd& b, const Eigen::VectorXd& u) {
  return {c, A, Eigen::VectorXd::Constant(b.size(), -kInfinity), b, Eigen::VectorXd::Zero(c.size()),
          u};
}

// maximise 3 x + 2 y, x + y <= 4, x <= 1: the optimum is 2 * 4 + (3 - 2) * 1, so that x's bound is
// worth 1; y = 3 is below its own bound of 9.
TEST(BoundPrices, AreReducedCostsAtAPlainVertex) {
  const LinearProgram program = program_of(Vector2d(3, 2), Eigen::RowVector2d(1, 1),
                                           Eigen::VectorXd::Constant(1, 4), Vector2d(1, 9));
  const BoundPrices prices = upper_bound_prices(program, solve(program));
  EXPECT_TRUE(matrix_near(prices.increase, Vector2d(1, 0), 1e-12));
  EXPECT_TRUE(matrix_near(prices.decrease, Vector2d(1, 0), 1e-12));
}

// maximise x + y, x + y <= 2, x <= 1, y <= 1: three bounds meet at (1, 1). More room for one of
// them gives nothing, less takes its whole self.
TEST(BoundPrices, DifferWhereThreeBoundsMeet) {
  const LinearProgram program = program_of(Vector2d(1, 1), Eigen::RowVector2d(1, 1),
                                           Eigen::VectorXd::Constant(1, 2), Vector2d(1, 1));
  const BoundPrices prices = upper_bound_prices(program, solve(program));
  EXPECT_TRUE(matrix_near(prices.increase, Vector2d(0, 0), 1e-12));
  EXPECT_TRUE(matrix_near(prices.decrease, Vector2d(1, 1), 1e-12));
}

// maximise x with x = y and y <= 1 tied twice: the second equality says what the first does, so
// that duals are not unique, and the price of y's bound is 1 all the same.
TEST(BoundPrices, AreUniqueAlsoWhereDualsAreNot) {
  LinearProgram program;
  program.objective = Vector2d(1, 0);
  program.A = (Eigen::MatrixXd(2, 2) << 1, -1, 1, -1).finished();
  program.row_lower = program.row_upper = Vector2d(0, 0);
  program.lower = Vector2d(0, 0);
  program.upper = Vector2d(kInfinity, 1);
  const BoundPrices prices = upper_bound_prices(program, solve(program));
  EXPECT_TRUE(matrix_near(prices.increase, Vector2d(0, 1), 1e-12));
  EXPECT_TRUE(matrix_near(prices.decrease, Vector2d(0, 1), 1e-12));
}

// x >= 1 is asked for by a row and x <= 1 by the bound: below it there is no answer.
TEST(BoundPrices, AreInfiniteWhereNothingIsLeftBelow) {
  LinearProgram program;
  program.objective = Eigen::VectorXd::Ones(1);
  program.A = Eigen::MatrixXd::Ones(1, 1);
  program.row_lower = Eigen::VectorXd::Ones(1);
  program.row_upper = Eigen::VectorXd::Constant(1, kInfinity);
  program.lower = Eigen::VectorXd::Zero(1);
  program.upper = Eigen::VectorXd::Ones(1);
  const BoundPrices prices = upper_bound_prices(program, solve(program));
  EXPECT_NEAR(prices.increase(0), 1, 1e-12);
  EXPECT_EQ(prices.decrease(0), kInfinity);
}

TEST(BoundPrices, RefuseAProgramWithoutOptimum) {
  LinearProgram program;
  program.objective = Eigen::VectorXd::Ones(1);
  program.A.resize(0, 1);
  program.row_lower = program.row_upper = Eigen::VectorXd(0);
  program.lower = Eigen::VectorXd::Zero(1);
  program.upper = Eigen::VectorXd::Constant(1, kInfinity);
  EXPECT_THROW((void)upper_bound_prices(program, solve(program)), InputError);
}

}  // namespace
}  // namespace thenar
