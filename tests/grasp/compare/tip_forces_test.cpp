// Tests for grasp/compare/tip_forces.cpp: how hard tips press.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "grasp/compare/abilities.h"
#include "grasp/robot_hand.h"
#include "tendons/hand/human_hand.h"
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

TipForces in_the_middle(const Hand& hand, int tip) {
  return tip_forces(hand, (hand.layout().lower + hand.layout().upper) / 2, tip);
}

// The file's effort is worked out by hand from 15 N at the tip [Townsend2000]; the nearest of 64
// directions is at most 12 degrees off.
TEST(TipForces, OfABarrettHandArePublished) {
  for (const char* name : {"barrett", "barrett_bh8_280"}) {
    const RobotHand hand(read_robot(std::string(THENAR_DATA_DIR) + "/robots/" + name + ".toml"));
    for (int tip = 0; tip < 3; ++tip) {
      EXPECT_LE(in_the_middle(hand, tip).largest, 15.05);  // effort of three figures
      EXPECT_GT(in_the_middle(hand, tip).largest, 15 * std::cos(0.21));
    }
  }
}

// Men pinch between the tips of thumb and index with some 76 N, women with some 50 N
// [Mathiowetz1985]; the middle of all ranges is not the strongest posture.
TEST(TipForces, OfAHumanIndexAreOfTheOrderOfAPinch) {
  HumanHandOptions bare;
  bare.cover = Cover::kNone;
  const HumanHand human = build_human_hand(default_human(), HumanTier::kTendonNet, bare);
  const std::vector<std::string>& tips = human.hand->layout().tips;
  const auto index = std::find(tips.begin(), tips.end(), "index") - tips.begin();
  const TipForces forces = in_the_middle(*human.hand, static_cast<int>(index));
  EXPECT_GT(forces.closing, 0.5 * 50);
  EXPECT_LT(forces.closing, 76);
  EXPECT_GE(forces.largest, 0.9 * forces.closing);
}

}  // namespace
}  // namespace thenar
