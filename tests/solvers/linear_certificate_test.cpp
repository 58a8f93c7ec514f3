// Tests for solvers/linear_certificate.cpp and dense_simplex.cpp.

#include "solvers/linear_certificate.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "base/numbers.h"
#include "solvers/dense_simplex.h"
#include "tests/matrix_near.h"
#include "tests/solvers/textbook_program.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using internal::certify;
using internal::dense_simplex;
using internal::is_certified;
using sample::textbook;

TEST(LinearCertificate, HoldsAtTheOptimum) {
  const LinearCertificate certificate = certify(textbook(), {Vector2d(3, 1), Vector2d(2, 0)});
  EXPECT_EQ(certificate.violation, 0);
  EXPECT_EQ(certificate.dual_violation, 0);
  EXPECT_EQ(certificate.gap, 0);
  EXPECT_TRUE(is_certified(certificate, 11));
}

// At (3, 0) the objective is 9: the same duals say that 2 is missing, which is the truth.
TEST(LinearCertificate, GapIsWhatAnotherVertexMisses) {
  const LinearCertificate certificate = certify(textbook(), {Vector2d(3, 0), Vector2d(2, 0)});
  EXPECT_EQ(certificate.gap, 2);
  EXPECT_FALSE(is_certified(certificate, 9));
}

// The objective falls by 1 where y falls to its lower bound, but x rises to where there is none.
TEST(LinearCertificate, PricesOfTheWrongSignAreUnpriced) {
  LinearProgram program = textbook();
  program.upper(0) = kInfinity;
  const LinearCertificate certificate = certify(program, {Vector2d(0, 0), Vector2d(0, 0)});
  EXPECT_EQ(certificate.dual_violation, 1);  // 3 of terms that add to 3
  EXPECT_FALSE(is_certified(certificate, 0));
}

TEST(LinearCertificate, ViolationsAreSeenInBoundsAndRows) {
  EXPECT_NEAR(certify(textbook(), {Vector2d(3, 2), Vector2d(2, 0)}).violation, 3.0 / 9, 1e-15);
  EXPECT_NEAR(certify(textbook(), {Vector2d(0, -1), Vector2d(2, 0)}).violation, 1, 1e-15);
}

// An activity beyond all numbers is within no bound, not even an infinite one.
TEST(LinearCertificate, RowsThatOverflowProveNothing) {
  LinearProgram program = textbook();
  program.A.row(1) << 1e300, 0;
  program.lower.setConstant(-kInfinity);
  program.upper.setConstant(kInfinity);
  program.row_upper.setConstant(kInfinity);
  const LinearCertificate certificate = certify(program, {Vector2d(1e200, 0), Vector2d(0, 0)});
  EXPECT_TRUE(std::isnan(certificate.violation)) << certificate.violation;
}

TEST(LinearCertificate, NaNProvesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_certified(certify(textbook(), {Vector2d(nan, 1), Vector2d(2, 0)}), 11));
  EXPECT_FALSE(is_certified(certify(textbook(), {Vector2d(3, 1), Vector2d(2, nan)}), 11));
}

// Basic are y and the activity of the second row: x = 3, x + y = 4.
TEST(LinearCertificate, VertexOfABasisIsExact) {
  const internal::PrimalDualPoint point =
      internal::vertex_of(textbook(), {{1, 3}, Eigen::Vector4d(3, 0, 4, 0)});
  EXPECT_TRUE(matrix_near(point.x, Vector2d(3, 1), 0));
  EXPECT_TRUE(matrix_near(point.duals, Vector2d(2, 0), 0));
}

TEST(DenseSimplex, FindsTextbookVertex) {
  const internal::SimplexVertex vertex = dense_simplex(textbook());
  EXPECT_EQ(vertex.claim, Status::kSolved);
  EXPECT_TRUE(matrix_near(internal::vertex_of(textbook(), vertex.basis).x, Vector2d(3, 1), 1e-15));
}

TEST(DenseSimplex, NamesContradictionAndUnboundedGrowth) {
  LinearProgram program = textbook();
  program.row_lower(0) = 5;  // against x <= 3 and x + 3y <= 6
  program.row_upper(0) = 6;
  EXPECT_EQ(dense_simplex(program).claim, Status::kInfeasible);
  program = textbook();
  program.row_upper.setConstant(kInfinity);
  EXPECT_EQ(dense_simplex(program).claim, Status::kUnbounded);
}

// Cycles under the steepest price alone: maximise 0.75 a - 150 b + 0.02 c - 6 d [Beale1955]; its
// optimum is 0.05.
TEST(DenseSimplex, EndsWhereSteepestPricesCycle) {
  LinearProgram program;
  program.objective = Eigen::Vector4d(0.75, -150, 0.02, -6);
  program.A = (MatrixXd(3, 4) << 0.25, -60, -0.04, 9, 0.5, -90, -0.02, 3, 0, 0, 1, 0).finished();
  program.row_lower = VectorXd::Constant(3, -kInfinity);
  program.row_upper = Eigen::Vector3d(0, 0, 1);
  program.lower = VectorXd::Zero(4);
  program.upper = VectorXd::Constant(4, kInfinity);
  const internal::SimplexVertex vertex = dense_simplex(program);
  EXPECT_EQ(vertex.claim, Status::kSolved);
  EXPECT_NEAR(program.objective.dot(internal::vertex_of(program, vertex.basis).x), 0.05, 1e-15);
}

// Programs with a point inside by construction, equalities, boxes and free variables. Both methods
// certify the same optimum.
TEST(DenseSimplex, AgreesWithTheProgramsAsked) {
  std::mt19937 rng(4);
  std::uniform_real_distribution<double> entry(-1, 1);
  for (int i = 0; i < 300; ++i) {
    const Index n = 4 + i % 9, rows = 1 + i % 4;
    LinearProgram program;
    program.objective = VectorXd::NullaryExpr(n, [&] { return entry(rng); });
    program.A = MatrixXd::NullaryExpr(rows, n, [&] { return entry(rng); });
    program.lower = VectorXd::Zero(n);
    program.upper = VectorXd::Ones(n);
    const VectorXd inside = VectorXd::NullaryExpr(n, [&] { return 0.5 + 0.5 * entry(rng); });
    program.row_lower = program.A * inside;
    program.row_upper = program.row_lower;
    if (rows > 1) program.row_lower(0) = -kInfinity;
    const internal::SimplexVertex vertex = dense_simplex(program);
    ASSERT_EQ(vertex.claim, Status::kSolved) << i;
    const internal::PrimalDualPoint point = internal::vertex_of(program, vertex.basis);
    const double objective = program.objective.dot(point.x);
    ASSERT_TRUE(is_certified(certify(program, point), objective)) << i;
    const LinearResult asked = solve(program);
    ASSERT_EQ(asked.status, Status::kSolved);
    ASSERT_TRUE(is_certified(asked.certificate, asked.objective));
    ASSERT_NEAR(asked.objective, objective, 1e-12) << i;
  }
}

}  // namespace
}  // namespace thenar
