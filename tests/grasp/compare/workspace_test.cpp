// Tests for grasp/compare/workspace.cpp: areas and volumes that tips sweep, in closed form.

#include <cmath>

#include <gtest/gtest.h>

#include "grasp/compare/workspace.h"
#include "grasp/robot/robot_hand.h"
#include "tests/grasp/closing_samples.h"

namespace thenar {
namespace {

constexpr double kReachOfTip = sample::kLength + sample::kRadius;  // of the tip [m]

/// Two hinges that turn each by itself, by up to 90 degrees.
RobotSpec planar_arm() {
  RobotSpec robot = sample::finger(DriveCoupling::kRigid);
  robot.joints[1].dof = "second";
  robot.joints[1].ratio = 1;
  robot.dofs.push_back(sample::motor("second", DriveCoupling::kRigid));
  return robot;
}

/// A tip that turns by 90 degrees about z, by up to 45 degrees off the plane, and slides outwards
/// by 60 mm.
RobotSpec telescope() {
  RobotSpec robot;
  robot.name = "telescope";
  robot.links = {{}, {}, {}, sample::phalanx("tip", "finger")};
  const std::vector<std::string> names{"base", "turret", "barrel"};
  for (std::size_t i = 0; i < names.size(); ++i) robot.links[i].name = names[i];
  robot.joints = {sample::hinge("turn", "base", "turret", {0, 0, 0}, "turn", 1),
                  sample::hinge("lift", "turret", "barrel", {0, 0, 0}, "lift", 1),
                  sample::hinge("slide", "barrel", "tip", {0, 0, 0}, "slide", 1)};
  robot.joints[1].axis = {0, -1, 0};
  robot.joints[1].upper = kPi / 4;
  robot.joints[2].kind = RobotJointKind::kPrismatic;
  robot.joints[2].axis = {1, 0, 0};
  robot.joints[2].upper = 0.06;
  for (const RobotJoint& joint : robot.joints) {
    robot.dofs.push_back(sample::motor(joint.name, DriveCoupling::kRigid));
    robot.dofs.back().upper = joint.upper;
  }
  return robot;
}

DigitAbility space_of(const RobotSpec& robot, int draws, double cell) {
  std::mt19937 random(1);
  return measure_workspaces(RobotHand(robot), draws, cell, random).digits.front();
}

// Angles a and b of [0, pi/2]: area  integral l1 l2 sin b da db = l1 l2 pi/2.
TEST(Workspace, OfAPlanarArmHasItsAreaWithinItsError) {
  for (const int draws : {3000, 30000})
    for (const double cell : {2e-3, 5e-3}) {
      const DigitAbility finger = space_of(planar_arm(), draws, cell);
      EXPECT_EQ(finger.dimension, 2);
      EXPECT_NEAR(finger.workspace, sample::kLength * kReachOfTip * kPi / 2, finger.workspace_error)
          << draws << " draws, cells of " << cell << " m";
    }
}

// Two joints on one motor: the tip bends along a curve, which spans a plane and fills none of it.
TEST(Workspace, OfOneMotorIsACurve) {
  EXPECT_EQ(space_of(sample::finger(DriveCoupling::kRigid), 3000, 5e-3).dimension, 1);
}

/// A hinge at the end of a twist about the link, both symmetric about straight.
RobotSpec twisted_arm() {
  RobotSpec robot = planar_arm();
  robot.joints[0].axis = {1, 0, 0};
  for (RobotJoint& joint : robot.joints) {
    joint.lower = -kPi / 2;
    joint.upper = kPi / 2;
  }
  for (RobotDof& dof : robot.dofs) {
    dof.lower = -kPi / 2;
    dof.upper = kPi / 2;
  }
  return robot;
}

// In the middle of its range the tip lies on the axis of the twist, which moves it everywhere else.
TEST(Workspace, CountsJointsThatDoNotMoveTheTipInTheMiddle) {
  EXPECT_EQ(space_of(twisted_arm(), 3000, 2e-3).dimension, 2);
}

TEST(Workspace, OfPlanarFingersShareNoVolume) {
  std::mt19937 random(1);
  EXPECT_TRUE(std::isnan(measure_workspaces(RobotHand(planar_arm()), 3000, 5e-3, random).overlap));
}

// Between radii r and R: volume  (R^3 - r^3) / 3  pi/2  sin 45 deg.
TEST(Workspace, OfATelescopeHasThatOfItsShellWithinItsError) {
  const double exact =
      (std::pow(kReachOfTip + 0.06, 3) - std::pow(kReachOfTip, 3)) / 3 * kPi / 2 * std::sqrt(0.5);
  for (const int draws : {5000, 50000})
    for (const double cell : {3e-3, 5e-3}) {
      const DigitAbility tip = space_of(telescope(), draws, cell);
      EXPECT_EQ(tip.dimension, 3);
      EXPECT_NEAR(tip.workspace, exact, tip.workspace_error)
          << draws << " draws, cells of " << cell << " m";
    }
}

TEST(Workspace, IsKnownBetterByMoreDraws) {
  const DigitAbility few = space_of(telescope(), 5000, 5e-3);
  const DigitAbility many = space_of(telescope(), 50000, 5e-3);
  EXPECT_LT(many.workspace_error, 0.7 * few.workspace_error);
  EXPECT_LT(many.workspace_error, 0.25 * many.workspace);
}

}  // namespace
}  // namespace thenar
