// Tests for solvers/cone_program.cpp.

#include "solvers/cone_program.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSolved = 1e-9;  // ten times the tolerance asked for

/// min t  subject to  |x - (2, 3)| <= t,  x0 + x1 = 1.
ConeProgram distance_to_line() {
  return {Vector3d(1, 0, 0),         Eigen::RowVector3d(0, 1, 1), VectorXd::Ones(1),
          -MatrixXd::Identity(3, 3), Vector3d(0, -2, -3),         {3}};
}

/// The same with t <= most.
ConeProgram distance_to_line(double most) {
  ConeProgram program = distance_to_line();
  program.G.conservativeResize(4, 3);
  program.G.row(3) << 1, 0, 0;
  program.h.conservativeResize(4);
  program.h(3) = most;
  program.cones.push_back(1);
  return program;
}

TEST(ConeProgram, FindsDistanceOfPointFromLine) {
  const ConeResult result = solve(distance_to_line());
  ASSERT_EQ(result.status, Status::kSolved);
  EXPECT_NEAR(result.objective, 4 / std::sqrt(2.0), kSolved);
  EXPECT_NEAR(result.dual, 4 / std::sqrt(2.0), kSolved);
  EXPECT_TRUE(matrix_near(result.x.tail(2), Eigen::Vector2d(0, 1), kSolved));
}

// c + A'y + G'z = 0 with z in the cone: a proof of optimality that needs no solver.
TEST(ConeProgram, ProvesOptimalityByItsMultipliers) {
  const ConeProgram p = distance_to_line();
  const ConeResult result = solve(p);
  EXPECT_TRUE(matrix_near(p.c + p.A.transpose() * result.y + p.G.transpose() * result.z,
                          Vector3d::Zero(), kSolved));
  EXPECT_LE(result.z.tail(2).norm(), result.z(0) + kSolved);
}

TEST(ConeProgram, ProvesInfeasibility) {
  EXPECT_EQ(solve(distance_to_line(2.8)).status, Status::kInfeasible);
  EXPECT_EQ(solve(distance_to_line(2.9)).status, Status::kSolved);
}

// Farkas: A'y + G'z = 0 with z in K and b'y + h'z < 0 rules every x out, and needs no solver.
void expect_proof(const ConeProgram& p, const ConeResult& result, const std::string& about) {
  ASSERT_EQ(result.status, Status::kInfeasible) << about;
  VectorXd e = p.G.transpose() * result.z;
  if (p.A.size() > 0) e += p.A.transpose() * result.y;
  const double gain = -p.h.dot(result.z) - (p.b.size() > 0 ? p.b.dot(result.y) : 0);
  EXPECT_GT(gain, 0) << about;
  EXPECT_LE(e.norm(), 1e-6 * gain) << about;
  EXPECT_NEAR(result.residual, e.norm() / gain, 1e-9) << about;
  for (int row = 0, k = 0; k < static_cast<int>(p.cones.size()); row += p.cones[k++])
    EXPECT_LE(result.z.segment(row + 1, p.cones[k] - 1).norm(), result.z(row) + kSolved) << about;
}

TEST(ConeProgram, StatesTheProofOfInfeasibility) {
  expect_proof(distance_to_line(2.8), solve(distance_to_line(2.8)), "too near");
  ConeProgram p = distance_to_line();
  p.A.conservativeResize(2, 3);
  p.A.row(1) << 0, 2, 2;
  p.b = Eigen::Vector2d(1, 3);
  expect_proof(p, solve(p), "contradiction");
}

// The objective falls along x0 for ever, but w is asked to be above `most` + 1 and below `most`:
// there is no point to fall from, whatever the ray says.
TEST(ConeProgram, CallsNothingUnboundedThatHasNoPoint) {
  for (const double fall : {1e-3, 1.0, 1e3, 1e6})
    for (const double apart : {1e-2, 1.0, 1e2}) {
      ConeProgram p{Eigen::Vector2d(fall, 0), {},       {}, MatrixXd::Zero(3, 2),
                    VectorXd::Zero(3),        {1, 1, 1}};
      p.G(0, 0) = 1;   // x0 <= 0
      p.G(1, 1) = -1;  // w >= apart
      p.h(1) = -apart;
      p.G(2, 1) = 1;  // w <= 0
      expect_proof(p, solve(p), std::to_string(fall) + " " + std::to_string(apart));
    }
}

TEST(ConeProgram, SolvesWhereOnlyOnePointIsFeasible) {
  const ConeResult result = solve(distance_to_line(4 / std::sqrt(2.0)));
  ASSERT_EQ(result.status, Status::kSolved);
  EXPECT_NEAR(result.objective, 4 / std::sqrt(2.0), 1e-7);  // its square root is what is certified
}

TEST(ConeProgram, CallsTheLimitOfItsIterationsALimit) {
  ConeOptions options;
  options.max_iterations = 1;
  const ConeResult result = solve(distance_to_line(), options);
  EXPECT_EQ(result.status, Status::kLimit);
  EXPECT_EQ(result.iterations, 1);
}

TEST(ConeProgram, ProvesUnboundedness) {
  ConeProgram program = distance_to_line();
  program.c = -program.c;
  EXPECT_EQ(solve(program).status, Status::kUnbounded);
}

TEST(ConeProgram, SeesThatNoConeBoundsTheObjective) {
  ConeProgram program = distance_to_line();
  program.G.rightCols(1).setZero();
  program.A.setZero();
  program.b.setZero();
  program.c << 1, 0, 1;
  EXPECT_EQ(solve(program).status, Status::kUnbounded);
}

TEST(ConeProgram, TakesRedundantEqualitiesAndRefusesContradictions) {
  ConeProgram program = distance_to_line();
  program.A.conservativeResize(2, 3);
  program.A.row(1) << 0, 2, 2;
  program.b = Eigen::Vector2d(1, 2);
  EXPECT_NEAR(solve(program).objective, 4 / std::sqrt(2.0), kSolved);
  program.b = Eigen::Vector2d(1, 3);
  EXPECT_EQ(solve(program).status, Status::kInfeasible);
}

// Over { |z_i| <= a_i, sum a_i <= 1 } the least of a sum of c_i a_i + g_i'z_i is the least of
// c_i - |g_i|, or 0.
TEST(ConeProgram, SolvesRandomProgramsWithKnownAnswers) {
  std::mt19937 rng(1);
  const auto number = [&] { return 2.0 * rng() / std::mt19937::max() - 1; };
  for (int trial = 0; trial < 300; ++trial) {
    const int cones = 1 + trial % 8, n = 3 * cones;
    ConeProgram p{VectorXd::NullaryExpr(n, number), {}, {}, MatrixXd::Zero(n + 1, n),
                  VectorXd::Unit(n + 1, n),         {}};
    p.G.topRows(n) = -MatrixXd::Identity(n, n);
    double expected = 0;
    for (int i = 0; i < cones; ++i) {
      p.G(n, 3 * i) = 1;
      p.cones.push_back(3);
      expected = std::min(expected, p.c(3 * i) - p.c.segment(3 * i + 1, 2).norm());
    }
    p.cones.push_back(1);
    const ConeResult result = solve(p);
    ASSERT_EQ(result.status, Status::kSolved) << trial;
    ASSERT_NEAR(result.objective, expected, kSolved) << trial;
  }
}

TEST(ConeProgram, RefusesShapesThatDisagree) {
  ConeProgram program = distance_to_line();
  program.cones = {2};
  EXPECT_EQ(message_of([&] { (void)solve(program); }), "cones have 2 rows in all, h 3");
}

}  // namespace
}  // namespace thenar
