// Tests for grasp/compare/tip_forces.cpp: how hard tips press.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "grasp/compare/tip_forces.h"
#include "grasp/robot/robot_hand.h"
#include "hand_versions/human_hand.h"
#include "tests/grasp/closing_samples.h"
#include "tests/grasp/jaws.h"

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
  EXPECT_NEAR(forces.largest, 2 / kArm, 1e-6);  // across the arm is the only way
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
  RobotSpec robot = sample::finger(DriveCoupling::kBreakaway);
  robot.dofs[0].max_effort = 0.3;
  robot.dofs[0].breakaway = 0.1;
  robot.dofs[0].backdrivable = false;
  for (RobotJoint& joint : robot.joints) joint.lower = -0.5;
  robot.dofs[0].lower = -0.5;
  EXPECT_NEAR(tip_forces(RobotHand(robot), Eigen::Vector2d(0, 0), 0).closing, 0.6 / kArm, 1e-6);
}

/// Two hinges in series, each with a motor of its own.
RobotSpec two_hinges(double inner, double outer) {
  RobotSpec robot = sample::finger(DriveCoupling::kRigid);
  robot.joints[1].dof = "distal";
  robot.joints[1].ratio = 1;
  robot.dofs = {sample::motor("proximal", DriveCoupling::kRigid),
                sample::motor("distal", DriveCoupling::kRigid)};
  robot.joints[0].dof = "proximal";
  robot.dofs[0].max_effort = inner;
  robot.dofs[1].max_effort = outer;
  return robot;
}

// Two joints and a force in their plane: f = J^-T tau, and |f| is largest in a corner of the
// rectangle of torques.
TEST(TipForces, LargestIsInACornerOfTheTorques) {
  const RobotHand hand(two_hinges(3, 1));
  for (const double bent : {0.4, 0.9, 1.4}) {
    const Eigen::Vector2d q(0.3, bent);
    const HandTip& tip = hand.layout().tip_points[0];
    const Eigen::Matrix3Xd J = hand.jacobian(q, tip.link, tip.p).bottomRows<3>();
    const Eigen::Matrix3Xd inverse =
        J.transpose().completeOrthogonalDecomposition().pseudoInverse();
    const double same = (inverse * Eigen::Vector2d(3, 1)).norm(),
                 other = (inverse * Eigen::Vector2d(3, -1)).norm();
    EXPECT_NEAR(tip_forces(hand, q, 0).largest, std::max(same, other), 1e-6) << bent;
  }
}

// Virtual work of a pinch: 2 N of one motor move both jaws by its way, so 2 f = 2 N.
TEST(TipForces, OfJawsOfOneMotorShareItsEffort) {
  const RobotHand hand(sample::jaws());
  for (int tip = 0; tip < 2; ++tip)
    EXPECT_NEAR(tip_forces(hand, Eigen::VectorXd::Constant(1, 0.02), tip).closing, 1, 1e-6);
}

/// Two links of one tendon on a third of its own motor, which is strong: 1 : 0.5 : 0.5.
RobotSpec tendon_finger(double effort) {
  RobotSpec robot = sample::finger(DriveCoupling::kCompliant);
  robot.links.push_back(sample::phalanx("tip", "finger"));
  robot.joints[0].dof = "root";
  robot.joints[1].dof = "tendon";
  robot.joints.push_back(
      sample::hinge("outer", "distal", "tip", {sample::kLength, 0, 0}, "tendon", 0.5));
  robot.dofs = {sample::motor("root", DriveCoupling::kRigid),
                sample::motor("tendon", DriveCoupling::kCompliant)};
  robot.dofs[0].max_effort = 1000;
  robot.dofs[1].max_effort = effort;
  robot.dofs[1].upper = kPi;
  return robot;
}

// Both outer joints bend by 45 degrees and have the same torque u, so f has the same lever about
// both: it is parallel to the link between them, u / a with a = l3 sin 45 deg. Its share in the way
// of closing follows from that link's frame (x along it), where the tip moves by v.
TEST(TipForces, OfTwoJointsOfOneTendonAreParallelToTheLinkBetween) {
  const double u = 0.5, c = std::sqrt(0.5), l = sample::kLength, a = kArm * c;
  const Eigen::Vector2d v(-a + (l * c - a), a + l / 2 + (l * c + l + a));
  const RobotHand hand(tendon_finger(u));
  const Eigen::Vector3d q(0.4, kPi / 4, kPi / 4);
  EXPECT_NEAR(tip_forces(hand, q, 0).closing, u / a * -v.x() / v.norm(), 1e-5);
}

TipForces in_the_middle(const Hand& hand, int tip) {
  return tip_forces(hand, (hand.layout().lower + hand.layout().upper) / 2, tip);
}

RobotHand robot(const std::string& name) {
  return RobotHand(read_robot(std::string(THENAR_DATA_DIR) + "/robots/" + name + ".toml"));
}

// The file's effort is worked out by hand from 15 N at the tip [Townsend2000].
TEST(TipForces, OfABarrettHandArePublished) {
  for (const char* name : {"barrett", "barrett_bh8_280"}) {
    const RobotHand hand = robot(name);
    for (int tip = 0; tip < 3; ++tip) {
      EXPECT_NEAR(in_the_middle(hand, tip).largest, 15, 0.05);  // effort of three figures
    }
  }
}

// Each jaw presses with 80 N [DrakeModels].
TEST(TipForces, OfTheParallelJawAreThoseOfItsMaker) {
  for (int tip = 0; tip < 2; ++tip)
    EXPECT_NEAR(in_the_middle(robot("parallel_jaw"), tip).closing, 80, 1e-4);
}

// 5 N m on both knuckles; pads stay parallel, so that they move as the ends of the knuckles,
// 37.6 and 43 mm from their axes: 2 f |arm| = 5 N m.
TEST(TipForces, OfARobotiqAreHalfOfItsEffortByArm) {
  for (int tip = 0; tip < 2; ++tip)
    EXPECT_NEAR(in_the_middle(robot("robotiq_2f85"), tip).closing,
                5 / (2 * std::hypot(37.6e-3, 43e-3)), 1e-3);
}

// Men pinch between the tips of thumb and index with some 76 N, women with some 50 N
// [Mathiowetz1985]; the middle of all ranges is not the strongest posture.
TEST(TipForces, OfAHumanIndexAreOfTheOrderOfAPinch) {
  HumanHandOptions bare;
  bare.cover = Cover::kNone;
  const HumanHand human = build_human_hand(default_human(), HumanVersion::kTendonNet, bare);
  const std::vector<std::string>& tips = human.hand->layout().tips;
  const auto index = std::find(tips.begin(), tips.end(), "index") - tips.begin();
  const TipForces forces = in_the_middle(*human.hand, static_cast<int>(index));
  EXPECT_GT(forces.closing, 0.5 * 50);
  EXPECT_LT(forces.closing, 76);
  EXPECT_GE(forces.largest, forces.closing);
}

}  // namespace
}  // namespace thenar
