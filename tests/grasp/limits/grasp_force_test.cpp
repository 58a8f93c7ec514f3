// Tests for grasp/limits/grasp_force.cpp.

#include "grasp/limits/grasp_force.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/grasp/quality/pinch.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

constexpr double kSolved = 1e-8;  // of forces of order 10 N

ScaledWrench weight(double newton) { return -newton * ScaledWrench::unit(2); }

// Two fingers on a ball, friction mu, weight w across: each carries w / 2 by friction, so each
// presses w / (2 mu).
TEST(GraspForce, IsWeightByTwiceFrictionForAPinch) {
  const GraspForce hold =
      minimum_grasp_force(free_forces(pinch(0.5, 0)), weight(8), GraspForceObjective::kSum);
  ASSERT_EQ(hold.status, Status::kSolved);
  EXPECT_NEAR(hold.objective, 16, kSolved);
  EXPECT_TRUE(matrix_near(hold.forces.normal, Eigen::Vector2d(8, 8), kSolved));
  EXPECT_LT(hold.unbalanced.norm(), kSolved);
  EXPECT_LT(hold.residual, 1e-10);
}

// The largest is half the sum here, by symmetry.
TEST(GraspForce, KeepsTheLargestForceSmall) {
  const GraspForce hold =
      minimum_grasp_force(free_forces(pinch(0.5, 0)), weight(8), GraspForceObjective::kLargest);
  ASSERT_EQ(hold.status, Status::kSolved);
  EXPECT_NEAR(hold.objective, 8, kSolved);
}

// A weight w off the axis by d twists the object by w d about the line of the contacts, which hard
// points cannot resist. Soft ones of torsion e resist 2 e f; with f sideways and the ellipsoid
// (w / (2 mu f))^2 + (w d / (2 e f))^2 <= 1 the least f follows.
TEST(GraspForce, NeedsSoftFingersAgainstTwist) {
  const double w = 2, d = 0.01, e = 0.004, mu = 0.5;
  ScaledWrench load = weight(w);
  load.moment_over_length.x() = w * d / kScale;  // about x, the line of the contacts
  EXPECT_EQ(minimum_grasp_force(free_forces(pinch(mu, 0)), load, GraspForceObjective::kSum).status,
            Status::kInfeasible);
  const GraspForce hold =
      minimum_grasp_force(free_forces(pinch(mu, e)), load, GraspForceObjective::kLargest);
  ASSERT_EQ(hold.status, Status::kSolved);
  EXPECT_NEAR(hold.objective, std::hypot(w / (2 * mu), w * d / (2 * e)), kSolved);
}

TEST(GraspForce, NeedsNothingWithoutLoad) {
  const GraspForce hold =
      minimum_grasp_force(free_forces(pinch(0.5, 0)), ScaledWrench{}, GraspForceObjective::kSum);
  ASSERT_EQ(hold.status, Status::kSolved);
  EXPECT_NEAR(hold.objective, 0, kSolved);
}

TEST(GraspForce, SaysThatWithoutFrictionOrContactsNothingIsHeld) {
  EXPECT_EQ(
      minimum_grasp_force(free_forces(pinch(0, 0)), weight(1), GraspForceObjective::kSum).status,
      Status::kInfeasible);
  EXPECT_EQ(minimum_grasp_force(free_forces({}), weight(1), GraspForceObjective::kSum).status,
            Status::kInfeasible);
}

// Two sliding fingers of at most 6 N hold mu 12 N.
TEST(GraspForce, KeepsWithinTheMotors) {
  const ForceSet hand = hand_forces(pinch(0.5, 0), pinch_torques(0.5, 0), pinch_motors(0, 6));
  EXPECT_EQ(minimum_grasp_force(hand, weight(6.1), GraspForceObjective::kSum).status,
            Status::kInfeasible);
  const GraspForce hold = minimum_grasp_force(hand, weight(5), GraspForceObjective::kSum);
  ASSERT_EQ(hold.status, Status::kSolved);
  EXPECT_TRUE(matrix_near(hold.forces.efforts, Eigen::Vector2d(5, 5), kSolved));
}

}  // namespace
}  // namespace thenar
