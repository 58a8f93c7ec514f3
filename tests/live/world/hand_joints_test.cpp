// Tests for live/hand_joints.cpp.

#include "live/world/hand_joints.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "api/named/hands.h"
#include "data/io/robot/import_robot.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/robot/robot_hand.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

constexpr double kExact = 1e-9;  // rounding of poses 2 m long, through a chain of 20 joints

/// Within the limits, off the middle, so that no joint stands at 0.
Eigen::VectorXd inner_posture(const HandLayout& layout) {
  const auto bounded = [](double value) { return std::clamp(value, -2.0, 2.0); };
  return 0.6 * layout.lower.unaryExpr(bounded) + 0.4 * layout.upper.unaryExpr(bounded);
}

/// How a link moves in its own frame when a coordinate goes on by `by`.
Pose<double> motion_of(const Hand& hand, const Eigen::VectorXd& q, const HandJoint& joint,
                       double by) {
  Eigen::VectorXd moved = q;
  moved[joint.coordinate] += by;
  const auto link = static_cast<std::size_t>(joint.link);
  return hand.pose(q)[link].inverse() * hand.pose(moved)[link];
}

/// Every joint turns its link about the axis that is drawn, or slides it along.
void expect_axes_drawn(const Hand& hand, const std::string& name) {
  constexpr double kBy = 0.02;  // [rad] or [m]
  const Eigen::VectorXd q = inner_posture(hand.layout());
  const std::vector<HandJoint> joints = hand_joints(hand);
  EXPECT_EQ(joints.size(), hand.layout().coordinates.size()) << name;
  for (const HandJoint& joint : joints) {
    SCOPED_TRACE(name + " " +
                 hand.layout().coordinates[static_cast<std::size_t>(joint.coordinate)]);
    const Pose<double> X = motion_of(hand, q, joint, kBy);
    EXPECT_NEAR(joint.axis.norm(), 1, kExact);
    if (joint.slides) {
      EXPECT_TRUE(matrix_near(X.R, Eigen::Matrix3d::Identity(), kExact));
      EXPECT_TRUE(matrix_near(X.p.normalized(), joint.axis, kExact));
      continue;
    }
    // Points of the axis stay, and the turn has the sense of the axis.
    for (const double along : {-0.1, 0.0, 0.2}) {
      const Eigen::Vector3d p = joint.point + along * joint.axis;
      EXPECT_TRUE(matrix_near(X * p, p, kExact));
    }
    const double angle = Eigen::AngleAxisd(X.R).angle();
    EXPECT_GT(angle, 1e-4);
    EXPECT_TRUE(matrix_near(X.R, rotation_about(joint.axis, angle), kExact));
  }
}

TEST(HandJoints, EveryRobotTurnsAboutItsDrawnAxes) {
  int robots = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kData + std::string("/robots"))) {
    if (entry.path().extension() != ".toml") continue;
    expect_axes_drawn(RobotHand(import_robot(entry.path().string())), entry.path().stem().string());
    ++robots;
  }
  EXPECT_GE(robots, 16);
}

TEST(HandJoints, HumanHandsTurnAboutTheirDrawnAxes) {
  HumanHandOptions bare;
  bare.cover = Cover::kNone;
  for (const char* version : {"human:orthogonal", "human:skewed", "human:tendons"})
    expect_axes_drawn(*hand_by_name(version, {kData}, bare).hand, version);
}

TEST(HandJoints, FollowersOfABarrettFingerTurnByTheRatioOfItsGears) {
  const RobotSpec robot = import_robot(kData + std::string("/robots/barrett.toml"));
  const RobotHand hand(robot);
  const std::vector<JointCoupling> couplings = joint_couplings(hand);
  int followers = 0;
  for (std::size_t c = 0; c < couplings.size(); ++c) {
    if (couplings[c].leader < 0) continue;
    ++followers;
    // The robot's own answer: where its motors move both.
    for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
      Eigen::VectorXd dofs = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.dofs.size()));
      dofs[static_cast<Eigen::Index>(d)] = 0.5;
      const Eigen::VectorXd q = hand.posture(dofs);
      EXPECT_NEAR(q[static_cast<Eigen::Index>(c)], couplings[c].ratio * q[couplings[c].leader],
                  1e-15);
    }
  }
  EXPECT_EQ(followers, 3);  // the outer joint of each finger
}

TEST(HandJoints, NoJointOfAHumanHandFollowsAnother) {
  HumanHandOptions bare;
  bare.cover = Cover::kNone;
  for (const JointCoupling& lead : joint_couplings(*hand_by_name("human:soft", {kData}, bare).hand))
    EXPECT_EQ(lead.leader, -1);
}

}  // namespace
}  // namespace thenar
