// Tests for grasp/compare/tip_forces.cpp: how hard tips press.

#include <cmath>

#include <gtest/gtest.h>

#include "grasp/compare/abilities.h"
#include "grasp/robot_hand.h"
#include "tests/grasp/closing_samples.h"

namespace thenar {
namespace {

constexpr double kArm = sample::kLength + sample::kRadius;  // of the tip [m]

RobotSpec pincer() {
  RobotSpec robot = sample::pincer(0.1);
  for (RobotDof& dof : robot.dofs) dof.max_effort = 2;
  return robot;
}

// One hinge: effort 2 N m at 58 mm.
TEST(TipForces, OfOneHingeIsEffortByArm) {
  const TipForces forces = tip_forces(RobotHand(pincer()), Eigen::Vector2d(0.3, 0.3), 0);
  EXPECT_NEAR(forces.closing, 2 / kArm, 1e-6);
  EXPECT_LE(forces.largest, forces.closing + 1e-6);
  EXPECT_GT(forces.largest, 0.9 * forces.closing);  // the nearest of 64 directions
}

// The stop of an open finger bears what pushes it open, so it presses without limit; its motor
// presses the other way.
TEST(TipForces, OfAnOpenFingerLeanOnItsStop) {
  const RobotHand hand(pincer());
  EXPECT_EQ(tip_forces(hand, Eigen::Vector2d(0, 0), 0).closing,
            std::numeric_limits<double>::infinity());
  EXPECT_NEAR(tip_forces(hand, hand.layout().upper, 0).closing, 2 / kArm, 1e-6);
}

TEST(TipForces, AreUnknownWhereTheEffortIs) {
  RobotSpec robot = pincer();
  robot.dofs[0].nominal_effort = true;
  const TipForces forces = tip_forces(RobotHand(robot), Eigen::Vector2d(0.3, 0.3), 0);
  EXPECT_TRUE(std::isnan(forces.closing));
  EXPECT_TRUE(std::isnan(forces.largest));
  EXPECT_NEAR(tip_forces(RobotHand(robot), Eigen::Vector2d(0.3, 0.3), 1).closing, 2 / kArm, 1e-6);
}

// The outer joint moves by half and gets 2 u, at 58 mm; worms bear the inner one. Both joints move
// the tip on the same line while the finger is straight.
TEST(TipForces, OfABreakawayFingerAreThoseOfItsOuterJoint) {
  RobotSpec robot = sample::finger(RobotDofKind::kBreakaway);
  robot.dofs[0].max_effort = 0.3;
  robot.dofs[0].breakaway = 0.1;
  robot.dofs[0].backdrivable = false;
  for (RobotJoint& joint : robot.joints) joint.lower = -0.5;
  robot.dofs[0].lower = -0.5;
  EXPECT_NEAR(tip_forces(RobotHand(robot), Eigen::Vector2d(0, 0), 0).closing, 0.6 / kArm, 1e-6);
}

}  // namespace
}  // namespace thenar
