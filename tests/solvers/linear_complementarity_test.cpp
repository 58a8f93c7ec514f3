// Tests for solvers/linear_complementarity.cpp.

#include "solvers/linear_complementarity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <Eigen/LU>

#include "base/error.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kRounding = 1e-13;

MatrixXd normal_matrix(std::mt19937& rng, Index rows, Index columns) {
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(rng); });
}

/// Whether some choice of basic variables, w_i or z_i in each row, is an answer: 2^n linear
/// systems.
bool has_answer(const LinearComplementarity& problem) {
  const Index n = problem.q.size();
  for (int choice = 0; choice < (1 << n); ++choice) {
    MatrixXd B = MatrixXd::Identity(n, n);
    for (Index i = 0; i < n; ++i)
      if ((choice >> i & 1) != 0) B.col(i) = -problem.M.col(i);
    const Eigen::FullPivLU<MatrixXd> lu(B);
    if (lu.isInvertible() && lu.solve(problem.q).minCoeff() >= -1e-9) return true;
  }
  return false;
}

// By hand: z1 = 4/3, z2 = 7/3 solve 2 z1 + z2 = 5, z1 + 2 z2 = 6.
TEST(LinearComplementarity, SolvesExampleByHand) {
  Matrix2d M;
  M << 2, 1, 1, 2;
  const ComplementaritySolution found = solve_complementarity({M, Vector2d(-5, -6)});
  ASSERT_EQ(found.status, Status::kSolved);
  EXPECT_TRUE(matrix_near(found.z, Vector2d(4.0 / 3, 7.0 / 3), kRounding));
  EXPECT_TRUE(matrix_near(found.w, Vector2d(0, 0), kRounding));
}

// A diagonal M splits into rows:  z = max(0, -q / m).
TEST(LinearComplementarity, SolvesRowsOneByOneWhereTheyDoNotMeet) {
  std::mt19937 rng(1);
  const VectorXd m = normal_matrix(rng, 30, 1).cwiseAbs(), q = normal_matrix(rng, 30, 1);
  const ComplementaritySolution found = solve_complementarity({m.asDiagonal(), q});
  ASSERT_EQ(found.status, Status::kSolved);
  EXPECT_TRUE(matrix_near(found.z, (-q).cwiseQuotient(m).cwiseMax(0), 1e-11));
}

TEST(LinearComplementarity, AnswersAtOnceWhereNothingIsNegative) {
  const ComplementaritySolution found =
      solve_complementarity({-Matrix2d::Identity(), Vector2d(1, 0)});
  EXPECT_EQ(found.status, Status::kSolved);
  EXPECT_EQ(found.z, Vector2d(0, 0));
  EXPECT_EQ(found.pivots, 0);
}

// Positive semidefinite plus skew is copositive-plus: an answer, or a proof that there is none.
TEST(LinearComplementarity, AgreesWithAllComplementaryBases) {
  std::mt19937 rng(2);
  int solved = 0, infeasible = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Index n = 1 + trial % 7, rank = (n + 1) / 2;
    const MatrixXd L = normal_matrix(rng, n, rank), S = normal_matrix(rng, n, n);
    MatrixXd M = L * L.transpose();
    if (trial % 3 == 0) M += S - S.transpose();
    const LinearComplementarity problem{M, normal_matrix(rng, n, 1)};
    const ComplementaritySolution found = solve_complementarity(problem);
    const bool exists = has_answer(problem);
    // Nearly singular bases have large z; no residual is smaller than the rounding of M z.
    const double rounding = 1e-15 * M.cwiseAbs().maxCoeff() * found.z.cwiseAbs().sum() /
                            problem.q.cwiseAbs().maxCoeff();
    if (exists) {
      EXPECT_LE(found.residual, std::max(1e-10, rounding)) << trial;
    } else {
      EXPECT_EQ(found.status, Status::kInfeasible) << trial;
    }
    solved += exists ? 1 : 0;
    infeasible += exists ? 0 : 1;
  }
  EXPECT_GT(solved, 100);
  EXPECT_GT(infeasible, 20);
}

TEST(LinearComplementarity, SolvesLargeProblemsToRounding) {
  std::mt19937 rng(3);
  const MatrixXd L = normal_matrix(rng, 150, 150);
  const ComplementaritySolution found =
      solve_complementarity({L * L.transpose(), normal_matrix(rng, 150, 1)});
  ASSERT_EQ(found.status, Status::kSolved);
  EXPECT_LT(found.residual, 1e-12);
}

// Equal rows tie in every ratio test; cyclic rules of pivoting may go round for ever there.
TEST(LinearComplementarity, EndsWhereEveryRatioTies) {
  const MatrixXd M = MatrixXd::Ones(12, 12);
  const ComplementaritySolution found = solve_complementarity({M, -VectorXd::Ones(12)});
  ASSERT_EQ(found.status, Status::kSolved);
  EXPECT_NEAR(found.z.sum(), 1, kRounding);
}

// w = -z - 1 is below zero for all z >= 0; y = 1 proves it.
TEST(LinearComplementarity, ProvesThatThereIsNoAnswer) {
  const LinearComplementarity problem{-MatrixXd::Identity(1, 1), -VectorXd::Ones(1)};
  EXPECT_EQ(solve_complementarity(problem).status, Status::kInfeasible);
  EXPECT_TRUE(proves_infeasible(problem, VectorXd::Ones(1)));
  EXPECT_FALSE(proves_infeasible(problem, -VectorXd::Ones(1)));
}

// M = [0 1; -1 0], q = (-1, 1):  w1 = z2 - 1, w2 = 1 - z1,  with the answer z = (1, 1).
TEST(LinearComplementarity, SolvesSkewGame) {
  Matrix2d M;
  M << 0, 1, -1, 0;
  const ComplementaritySolution found = solve_complementarity({M, Vector2d(-1, 1)});
  ASSERT_EQ(found.status, Status::kSolved);
  EXPECT_TRUE(matrix_near(found.z, Vector2d(1, 1), kRounding));
}

// Rows and unknowns in other units: D M E, D q has the answer E^-1 z.
TEST(LinearComplementarity, FollowsUnits) {
  std::mt19937 rng(4);
  const MatrixXd L = normal_matrix(rng, 8, 8);
  const MatrixXd M = L * L.transpose();
  const VectorXd q = normal_matrix(rng, 8, 1);
  const ComplementaritySolution one = solve_complementarity({M, q});
  const ComplementaritySolution other = solve_complementarity({1e6 * M, 1e3 * q});
  ASSERT_EQ(one.status, Status::kSolved);
  ASSERT_EQ(other.status, Status::kSolved);
  EXPECT_TRUE(matrix_near(1e3 * other.z, one.z, 1e-9));
}

TEST(LinearComplementarity, StopsAtItsLimit) {
  std::mt19937 rng(5);
  const MatrixXd L = normal_matrix(rng, 20, 20);
  ComplementarityOptions options;
  options.max_pivots = 2;
  const ComplementaritySolution found =
      solve_complementarity({L * L.transpose(), -VectorXd::Ones(20)}, options);
  EXPECT_EQ(found.status, Status::kLimit);
  EXPECT_GT(found.residual, options.tolerance);
}

TEST(LinearComplementarity, ResidualSeesEveryFault) {
  const LinearComplementarity problem{Matrix2d::Identity(), Vector2d(-1, 2)};
  EXPECT_EQ(complementarity_residual(problem, Vector2d(1, 0)), 0);
  EXPECT_GT(complementarity_residual(problem, Vector2d(0.9, 0)), 0.04);  // w < 0
  EXPECT_GT(complementarity_residual(problem, Vector2d(1, 0.1)), 0.09);  // z w > 0
  EXPECT_GT(complementarity_residual(problem, Vector2d(1, -0.1)), 0.09);
}

TEST(LinearComplementarity, RefusesBadInput) {
  EXPECT_EQ(message_of<InputError>([] {
              (void)solve_complementarity({Matrix2d::Identity(), VectorXd::Ones(3)});
            }),
            "q has 3 rows, M is 2 by 2");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)solve_complementarity({Matrix2d::Identity(), Vector2d(nan, 1)}), InputError);
}

}  // namespace
}  // namespace thenar
