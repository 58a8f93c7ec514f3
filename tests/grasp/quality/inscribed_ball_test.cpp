// Tests for grasp/quality/inscribed_ball.cpp and task_wrenches.cpp.

#include "grasp/quality/inscribed_ball.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "grasp/quality/epsilon.h"
#include "grasp/quality/task_margin.h"
#include "tests/grasp/quality/pinch.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr double kSolvedBall = 1e-8;

/// Generators along both ways of every axis: each component of the wrench is free by itself.
WrenchSet axes() {
  WrenchSet set;
  for (int i = 0; i < 6; ++i)
    for (const double sign : {1.0, -1.0}) set.caps.push_back({sign * ScaledWrench::unit(i), {}});
  return set;
}

// The cross-polytope, all faces 1 / sqrt 6 off; with a limit for each generator, the cube.
TEST(InscribedBall, IsExactForPolytopes) {
  for (const auto& [limit, radius] :
       {std::pair(ForceNorm::kL1, 1 / std::sqrt(6.0)), std::pair(ForceNorm::kLinf, 1.0)}) {
    const InscribedBall ball = inscribed_ball(unit_forces(axes(), limit));
    ASSERT_EQ(ball.status, Status::kSolved);
    EXPECT_NEAR(ball.upper, radius, kSolvedBall);
    EXPECT_LE(ball.lower, radius + kSolvedBall);
    EXPECT_GE(ball.lower, 0.99 * radius - kSolvedBall);
  }
}

// epsilon() finds the same by supports that are formulas.
TEST(InscribedBall, AgreesWithEpsilonOnFrictionCones) {
  const WrenchSet set = pinch(0.5, 0.01);
  const InscribedBall ball = inscribed_ball(unit_forces(set, ForceNorm::kL1));
  const Epsilon expected = epsilon(set);
  ASSERT_EQ(ball.status, Status::kSolved);
  EXPECT_LE(ball.lower, expected.upper + kSolvedBall);
  EXPECT_GE(ball.upper, expected.lower - kSolvedBall);
  EXPECT_LE(ball.upper - ball.lower, 0.01 * ball.upper + kSolvedBall);
}

// What is between the bounds, widened by the residual, holds the closed form: the cross-polytope's
// 1 / sqrt 6, and 12 mu of two motors of 6 N.
TEST(InscribedBall, StatesTheResidualOfItsProgrammes) {
  const InscribedBall ball = inscribed_ball(unit_forces(axes(), ForceNorm::kL1));
  EXPECT_GT(ball.residual, 0);
  EXPECT_LT(ball.residual, 1e-9);
  EXPECT_LE(ball.lower - 2 * ball.residual, 1 / std::sqrt(6.0));
  EXPECT_GE(ball.upper + 2 * ball.residual, 1 / std::sqrt(6.0));

  const ForceSet hand = hand_forces(pinch(0.25, 0), pinch_torques(0.25, 0), pinch_motors(0, 6));
  const TaskMargin margin = margin_of_loads(hand, {ScaledWrench::unit(2), ScaledWrench::unit(1)});
  EXPECT_GT(margin.residual, 0);
  EXPECT_LT(margin.residual, 1e-9);
  EXPECT_LE(margin.lower, margin.upper);
  EXPECT_LE(margin.lower - 4 * margin.residual, 3);
  EXPECT_GE(margin.upper + 4 * margin.residual, 3);
}

// Hard fingers leave a twist: no ball, however strong the motors.
TEST(InscribedBall, IsZeroWhereALoadIsNotWithstood) {
  const ForceSet hand = hand_forces(pinch(0.5, 0), pinch_torques(0.5, 0), pinch_motors(0, 6));
  const InscribedBall ball = inscribed_ball(hand);
  EXPECT_NEAR(ball.upper, 0, kSolvedBall);
  EXPECT_NEAR(std::abs(ball.worst_load.moment_over_length.x()), 1, 1e-3);
}

// Both motors off: the only force is none.
TEST(InscribedBall, SaysWhereNoForceIsPossible) {
  const ForceSet hand = hand_forces(pinch(0.5, 0), pinch_torques(0.5, 0), pinch_motors(-3, -1));
  EXPECT_EQ(inscribed_ball(hand).status, Status::kInfeasible);
}

// One contact withstands nothing: upper is zero to rounding, of either sign, and lower below it.
TEST(InscribedBall, KeepsItsBoundsInOrderWhereNothingIsWithstood) {
  std::mt19937 rng(2);
  const auto number = [&] { return 2.0 * rng() / std::mt19937::max() - 1; };
  for (int trial = 0; trial < 30; ++trial) {
    const Eigen::Vector3d p = Eigen::Vector3d::NullaryExpr(number);
    const WrenchSet set = wrench_set({{p, -p.normalized(), 0.5, 0}}, {0, 0, 0}, 1);
    const InscribedBall ball = inscribed_ball(unit_forces(set, ForceNorm::kL1));
    ASSERT_LE(ball.lower, ball.upper);
    ASSERT_LE(ball.upper, kSolvedBall);
  }
}

TEST(TaskWrenches, WorstOfAListCounts) {
  const ForceSet hand = hand_forces(pinch(0.25, 0), pinch_torques(0.25, 0), pinch_motors(0, 6));
  const ScaledWrench across = ScaledWrench::unit(2), along = ScaledWrench::unit(0);
  const TaskMargin margin = margin_of_loads(hand, {along, across});
  EXPECT_NEAR(margin.lower, 0.25 * 12, kSolvedBall);
  EXPECT_EQ(margin.worst_load, across);
  EXPECT_EQ(margin_of_loads(hand, {}).lower, std::numeric_limits<double>::infinity());
}

// In the cross-polytope a load with corners (+-a, +-b) is withstood up to 1 / (a + b).
TEST(TaskWrenches, BoxIsAsGoodAsItsWorstCorner) {
  const ScaledWrench half{{2, 0, 0}, {0, 3, 0}};
  const TaskMargin margin = margin_of_box(unit_forces(axes(), ForceNorm::kL1), -half, half);
  EXPECT_NEAR(margin.lower, 1.0 / 5, kSolvedBall);
}

// Axes q_i: the cross-polytope's face is at k / sqrt(sum q_i^2), over those that are not zero.
TEST(TaskWrenches, EllipsoidIsExactInACrossPolytope) {
  const ForceSet forces = unit_forces(axes(), ForceNorm::kL1);
  const WrenchCoordinates q = (WrenchCoordinates() << 1, 2, 3, 0.5, 1, 2).finished();
  const TaskMargin full = margin_of_ellipsoid(forces, Eigen::MatrixXd(q.asDiagonal()));
  ASSERT_EQ(full.status, Status::kSolved);
  EXPECT_NEAR(full.upper, 1 / q.norm(), kSolvedBall);
  EXPECT_GE(full.lower, 0.99 / q.norm() - kSolvedBall);
  EXPECT_NEAR(full.worst_load.norm(), (q.cwiseProduct(q) / q.norm()).norm(), 1e-3);
  const Eigen::MatrixXd forces_only = Eigen::MatrixXd(q.asDiagonal()).leftCols(3);
  const TaskMargin flat = margin_of_ellipsoid(forces, forces_only);
  ASSERT_EQ(flat.status, Status::kSolved);
  EXPECT_NEAR(flat.upper, 1 / q.head<3>().norm(), kSolvedBall);
  EXPECT_GE(flat.lower, 0.99 / q.head<3>().norm() - kSolvedBall);
}

// A force k at an angle a to the line of the contacts: one finger presses f = 6, the other
// f - k cos a, and without torque each carries k sin a / 2 of the rest, at most mu (f - k cos a):
// k = 2 mu f / (sin a + 2 mu cos a), least 2 mu f / sqrt(1 + 4 mu^2).
TEST(TaskWrenches, ForcesWithoutTorqueNeedNoRank) {
  const double mu = 0.25, expected = 2 * mu * 6 / std::hypot(1, 2 * mu);
  const ForceSet hand = hand_forces(pinch(mu, 0), pinch_torques(mu, 0), pinch_motors(0, 6));
  const TaskMargin margin =
      margin_of_ellipsoid(hand, Eigen::Matrix<double, 6, 3>::Identity(), {2e-2, 1e4, 600});
  EXPECT_LE(margin.lower, expected + kSolvedBall);
  EXPECT_GE(margin.upper, expected - kSolvedBall);
  EXPECT_LE(margin.upper - margin.lower, 2e-2 * margin.upper + kSolvedBall);
}

TEST(TaskWrenches, RefusesAFlatEllipsoidOfTooManyAxes) {
  EXPECT_EQ(message_of([] {
              (void)margin_of_ellipsoid(unit_forces(axes(), ForceNorm::kL1),
                                        Eigen::Matrix<double, 6, 2>::Ones());
            }),
            "2 axes of the ellipsoid span 1 dimensions");
}

}  // namespace
}  // namespace thenar
