// Tests for data/io/robot/urdf_losses.cpp.

#include "data/io/robot/urdf_losses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace thenar::internal {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

RobotJoint joint_of(const std::string& name, double ratio, double offset) {
  RobotJoint joint;
  joint.name = name;
  joint.kind = RobotJointKind::kRevolute;
  joint.dof = "motor";
  joint.ratio = ratio;
  joint.offset = offset;
  return joint;
}

/// A motor from 0 to 2 that moves joints.
RobotSpec robot_of(const std::vector<RobotJoint>& joints) {
  RobotSpec robot;
  robot.dofs.emplace_back();
  robot.dofs[0].name = "motor";
  robot.dofs[0].upper = 2;
  robot.joints = joints;
  return robot;
}

TEST(UrdfLosses, TheFirstJointThatMovesAsItsMotorLeads) {
  const RobotSpec robot = robot_of({joint_of("a", 2, 0), joint_of("b", 1, 0)});
  EXPECT_EQ(leader_of(robot, "motor").name, "b");
  EXPECT_EQ(leader_of(robot_of({joint_of("a", 2, 0)}), "motor").name, "a");
}

// By hand: u^2 on 0 to 2 has the chord 2 u, 1 above it in the middle; the line lies 1/2 below.
TEST(UrdfLosses, ACurveBecomesTheLineOfTheSmallestError) {
  RobotJoint joint = joint_of("a", 0, 0);
  joint.curve = {1};
  const CouplingLine line = line_of(robot_of({joint}), joint);
  EXPECT_DOUBLE_EQ(line.ratio, 2);
  EXPECT_DOUBLE_EQ(line.offset, -0.5);
  EXPECT_DOUBLE_EQ(line.off, 0.5);
}

TEST(UrdfLosses, TellsOfSpringsAndOfNamesOfMotors) {
  RobotJoint joint = joint_of("a", 1, 0);
  joint.stiffness = 3;
  EXPECT_THAT(losses_in_urdf(robot_of({joint})),
              Contains(HasSubstr("no springs: that of joint 'a'")));
  EXPECT_THAT(losses_in_urdf(robot_of({joint})),
              Contains(HasSubstr("'motor' is that of joint 'a'")));
  EXPECT_THAT(losses_in_urdf({}), IsEmpty());
}

}  // namespace
}  // namespace thenar::internal
