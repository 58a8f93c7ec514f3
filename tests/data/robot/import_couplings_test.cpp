// Tests for data/io/robot/import_couplings.cpp.

#include "data/io/robot/import_couplings.h"
#include "base/lists.h"

#include <gmock/gmock.h>

#include "data/io/robot/link_poses.h"
#include "tests/message_of.h"

namespace thenar::internal {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A chain of hinges "1", "2", "3" from -1 to 1.
RobotSpec chain_of_hinges() {
  RobotSpec robot;
  robot.links.resize(4);
  for (int i = 0; i < 4; ++i) robot.links[static_cast<std::size_t>(i)].name = std::to_string(i);
  for (int i = 1; i <= 3; ++i) {
    RobotJoint joint;
    joint.name = joint.child = std::to_string(i);
    joint.parent = std::to_string(i - 1);
    joint.lower = -1;
    joint.upper = 1;
    robot.joints.push_back(joint);
  }
  return robot;
}

TEST(CoupleJoints, GivesUncoupledOnesTheirOwnMotor) {
  RobotSpec robot = chain_of_hinges();
  couple_joints(robot, {}, "f.xml");
  EXPECT_THAT(robot.dofs, SizeIs(3));
  EXPECT_EQ(robot.joints[1].dof, "2");
}

// 3 follows 2 = 0.1 + 0.5 v + 0.2 v^2 by 0.3 + 2 x - x^2, so it follows 1 by the composition.
TEST(CoupleJoints, ComposesPolynomialsOfFollowers) {
  RobotSpec robot = chain_of_hinges();
  robot.joints[2].lower = -5;
  robot.joints[2].upper = 5;
  couple_joints(robot, {{"2", "1", 0.5, 0.1, 1, {0.2}}, {"3", "2", 2, 0.3, 2, {-1}}}, "f.xml");
  ASSERT_THAT(robot.dofs, SizeIs(1));
  EXPECT_EQ(robot.joints[2].dof, "1");
  for (const double v : {-0.9, 0.0, 0.4}) {
    const double x = 0.1 + 0.5 * v + 0.2 * v * v;
    EXPECT_NEAR(joint_value(robot.joints[2], v), 0.3 + 2 * x - x * x, 1e-15);
  }
}

// Joint 2 = 2 v leaves its range of 1 beyond v = 0.5.
TEST(CoupleJoints, TightensTheRangeToWhatFollowersCanDo) {
  RobotSpec robot = chain_of_hinges();
  couple_joints(robot, {{"2", "1", 2, 0, 1, {}}}, "f.xml");
  EXPECT_DOUBLE_EQ(find_named(robot.dofs, "1")->lower, -0.5);
  EXPECT_DOUBLE_EQ(find_named(robot.dofs, "1")->upper, 0.5);
  EXPECT_THAT(robot.warnings, SizeIs(1));
}

TEST(CoupleJoints, RefusesCirclesAndUnknownJoints) {
  const auto refusal = [](const std::vector<FollowerCoupling>& couplings) {
    RobotSpec robot = chain_of_hinges();
    return message_of<DataError>([&] { couple_joints(robot, couplings, "f.xml"); });
  };
  EXPECT_THAT(refusal({{"2", "3", 1, 0, 4, {}}, {"3", "2", 1, 0, 5, {}}}),
              HasSubstr("follows itself"));
  EXPECT_THAT(refusal({{"2", "9", 1, 0, 4, {}}}), HasSubstr("f.xml:4: joint '2' follows '9'"));
}

TEST(OrderTree, PutsParentsFirst) {
  RobotSpec robot = chain_of_hinges();
  std::swap(robot.joints[0], robot.joints[2]);
  std::swap(robot.links[0], robot.links[3]);
  order_tree(robot, "f.xml");
  EXPECT_EQ(robot.links[0].name, "0");
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(robot.joints[static_cast<std::size_t>(i)].name, std::to_string(i + 1));
  robot.joints[0].parent = "3";
  EXPECT_THAT(message_of<DataError>([&] { order_tree(robot, "f.xml"); }), HasSubstr("ring"));
}

TEST(RangeThrough, TurnsLimitsIntoThoseOfTheMotor) {
  RobotJoint joint;
  joint.lower = -1;
  joint.upper = 2;
  joint.offset = 0.5;
  joint.ratio = -0.5;
  EXPECT_DOUBLE_EQ(range_through(joint).lower, -3);
  EXPECT_DOUBLE_EQ(range_through(joint).upper, 3);
}

}  // namespace
}  // namespace thenar::internal
