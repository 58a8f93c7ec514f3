// Tests for data/io/robot/check_robot.cpp.

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/data/robot/sample_robots.h"
#include "tests/message_of.h"

namespace thenar {
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
            "joint 'J3' is driven by 'grip', which is no degree of freedom");
}

TEST(CheckRobot, NamesLinksWithTwoParentsOrNone) {
  EXPECT_EQ(complaint([](RobotSpec& r) { r.joints[2].child = "distal"; }),
            "link 'distal' has two parents: 'proximal' and 'base'");
  EXPECT_EQ(complaint([](RobotSpec& r) { r.joints.pop_back(); }), "link 'tip' hangs on no joint");
  EXPECT_EQ(complaint([](RobotSpec& r) { std::swap(r.joints[0], r.joints[1]); }),
            "joint 'J2' stands before the joint that carries its parent 'proximal'");
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
