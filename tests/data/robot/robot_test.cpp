// Tests for data/io/robot/robot.cpp.

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/data/robot/sample_robots.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TEST(Attach, RenamesWhatTheCarrierHas) {
  RobotSpec tool = sample::small_robot(2);
  tool.name = "T";
  tool.links[3].name = "claw";
  tool.joints[2].child = "claw";
  std::mt19937 rng(3);
  const Pose<double> X = sample::random_pose(rng);
  const RobotSpec both = attach(sample::small_robot(), "jaw", tool, X);
  EXPECT_EQ(both.links.size(), 10U);
  EXPECT_EQ(both.links[5].name, "T/base");
  EXPECT_EQ(both.links[8].name, "claw");
  EXPECT_EQ(both.links[6].digit, "T/finger 1");
  EXPECT_EQ(both.joints[4].name, "T mount");
  EXPECT_EQ(both.joints[4].parent, "jaw");
  EXPECT_EQ(both.joints[4].child, "T/base");
  EXPECT_EQ(both.joints[4].X_PJ.p, X.p);
  EXPECT_EQ(both.joints[5].dof, "T/curl");
}

// Carrier: a slide at offset 0.2 m along x. The tool sits turned by 90 deg about z beyond it.
TEST(Attach, ApproachesAsTheToolDoes) {
  RobotSpec carrier;
  carrier.name = "slide";
  carrier.links.resize(2);
  carrier.links[0].name = "rail";
  carrier.links[1].name = "cart";
  carrier.joints.resize(1);
  carrier.joints[0].name = "way";
  carrier.joints[0].kind = RobotJointKind::kPrismatic;
  carrier.joints[0].parent = "rail";
  carrier.joints[0].child = "cart";
  carrier.joints[0].axis = {1, 0, 0};
  carrier.joints[0].offset = 0.2;
  RobotSpec tool;
  tool.name = "tool";
  tool.links.resize(1);
  tool.links[0].name = "palm";
  tool.approach = {{0.1, 0, 0}, {1, 0, 0}};
  Pose<double> X;
  X.R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  X.p << 0, 0, 0.5;
  const RobotApproach approach = attach(carrier, "cart", tool, X).approach;
  EXPECT_TRUE(matrix_near(approach.point, Eigen::Vector3d(0.2, 0.1, 0.5), 1e-15));
  EXPECT_TRUE(matrix_near(approach.direction, Eigen::Vector3d(0, 1, 0), 1e-15));
}

// A carrier of a format without closing would run away with its velocity limits as speeds.
TEST(Attach, HoldsACarrierStillOfWhichNoClosingIsStated) {
  RobotSpec carrier = sample::small_robot(), tool = sample::small_robot(2);
  tool.name = "T";
  carrier.dofs[0].speed = tool.dofs[0].speed = 2;
  const std::size_t first = carrier.dofs.size();
  EXPECT_EQ(attach(carrier, "jaw", tool, {}).dofs[0].speed, 2);
  carrier.closing_stated = false;
  const RobotSpec both = attach(carrier, "jaw", tool, {});
  EXPECT_EQ(both.dofs[0].speed, 0);
  EXPECT_EQ(both.dofs[first].speed, 2);
  EXPECT_TRUE(both.closing_stated);
}

TEST(Attach, RefusesALinkThereIsNot) {
  const RobotSpec robot = sample::small_robot();
  EXPECT_THAT(message_of([&] { (void)attach(robot, "claw", robot, {}); }),
              testing::HasSubstr("has no link 'claw'"));
}

}  // namespace
namespace {

template <typename Spoil>
std::string complaint(Spoil spoil) {
  RobotSpec robot = sample::small_robot();
  spoil(robot);
  return message_of([&] { check_robot(robot); });
}

TEST(CheckRobot, AcceptsASoundOne) { EXPECT_NO_THROW(check_robot(sample::small_robot())); }

TEST(CheckRobot, NamesLoops) {
  EXPECT_EQ(complaint([](RobotSpec& r) { r.joints[0].parent = "tip"; }),
            "joint 'J1' closes a loop: 'proximal' carries 'tip' already");
}

TEST(CheckRobot, NamesUnknownLinksAndMotors) {
  EXPECT_EQ(complaint([](RobotSpec& r) { r.joints[2].child = "claw"; }),
            "joint 'J3' names link 'claw', which there is not");
  EXPECT_EQ(complaint([](RobotSpec& r) { r.joints[2].dof = "grip"; }),
            "joint 'J3' is driven by 'grip', which is not a degree of freedom");
}

TEST(CheckRobot, NamesLinksWithTwoParentsOrNone) {
  EXPECT_EQ(complaint([](RobotSpec& r) { r.joints[2].child = "distal"; }),
            "link 'distal' has two parents: 'proximal' and 'base'");
  EXPECT_EQ(complaint([](RobotSpec& r) { r.joints.pop_back(); }), "link 'tip' hangs on no joint");
  EXPECT_EQ(complaint([](RobotSpec& r) { std::swap(r.joints[0], r.joints[1]); }),
            "joint 'J2' appears before the joint that carries its parent 'proximal'");
}

TEST(CheckRobot, NamesNumbersThatCannotBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
      complaint([](RobotSpec& r) { r.joints[0].lower = r.joints[0].upper + 1; }).substr(0, 27),
      "limits of joint 'J1' cross:");
  EXPECT_EQ(complaint([](RobotSpec& r) {
              r.joints[0].axis = {0, 0, 2};
            }),
            "wanted the axis of joint 'J1' as a unit vector, got [0, 0, 2]");
  EXPECT_THAT(complaint([](RobotSpec& r) { r.joints[0].X_PJ.R *= -1; }),
              testing::HasSubstr("rotation of joint 'J1'"));
  EXPECT_EQ(complaint([&](RobotSpec& r) { r.joints[0].offset = nan; }),
            "wanted the offset of joint 'J1' to be finite, got nan");
  EXPECT_EQ(complaint([&](RobotSpec& r) { r.dofs[0].max_effort = -1; }),
            "wanted the effort of degree of freedom 'curl' >= 0, got -1");
  EXPECT_EQ(complaint([](RobotSpec& r) { r.links[0].inertia(0, 1) += 1; }),
            "the inertia of link 'base' is not a body's");
  EXPECT_THAT(complaint([&](RobotSpec& r) { r.approach.direction *= 2; }),
              testing::HasSubstr("approach"));
}

// A rod has moments (0, m, m); (1, 1, 3) would need mass at imaginary distances.
TEST(CheckRobot, TellsInertiasOfBodies) {
  const auto diagonal = [](double x, double y, double z) {
    return is_body_inertia(Eigen::Vector3d(x, y, z).asDiagonal());
  };
  EXPECT_TRUE(diagonal(0, 0, 0));
  EXPECT_TRUE(diagonal(0, 1, 1));
  EXPECT_TRUE(diagonal(1, 2, 3));
  EXPECT_FALSE(diagonal(1, 1, 3));
  EXPECT_FALSE(diagonal(-1, 1, 1));
}

}  // namespace
}  // namespace thenar
