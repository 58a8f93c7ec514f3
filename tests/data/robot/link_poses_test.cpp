// Tests for data/io/robot/link_poses.cpp.

#include "data/io/robot/link_poses.h"

#include <cmath>

#include <gmock/gmock.h>

#include "base/units.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

RobotLink named_link(const std::string& name) {
  RobotLink link;
  link.name = name;
  return link;
}

/// A hinge about z at the end of a bar of length 1 along x, and a slide along x behind it.
RobotSpec crane() {
  RobotSpec robot;
  robot.links = {named_link("base"), named_link("arm"), named_link("hook")};
  RobotJoint turn, slide;
  turn.name = turn.dof = "turn";
  turn.parent = "base";
  turn.child = "arm";
  turn.X_PJ.p = {1, 0, 0};
  slide.name = "slide";
  slide.dof = "turn";
  slide.kind = RobotJointKind::kPrismatic;
  slide.parent = "arm";
  slide.child = "hook";
  slide.axis = {1, 0, 0};
  slide.offset = 0.5;
  slide.ratio = 2;
  slide.curve = {3};
  robot.joints = {turn, slide};
  return robot;
}

TEST(JointValue, IsItsPolynomial) {
  RobotJoint joint;
  joint.offset = 1;
  joint.ratio = -2;
  joint.curve = {3, 0.5};
  for (const double u : {-1.5, 0.0, 0.7})
    EXPECT_NEAR(joint_value(joint, u), 1 - 2 * u + 3 * u * u + 0.5 * u * u * u, 1e-14);
}

TEST(LinkPoses, MultiplyAlongTheTree) {
  for (const double u : {0.0, 0.4, -1.1}) {
    const std::vector<Pose<double>> X = link_poses(crane(), {{"turn", u}});
    const double way = 0.5 + 2 * u + 3 * u * u;
    EXPECT_NEAR((X[2].p - Eigen::Vector3d(1 + way * std::cos(u), way * std::sin(u), 0)).norm(), 0,
                1e-14);
    EXPECT_NEAR(X[2].R(1, 0), std::sin(u), 1e-15);
  }
}

TEST(LinkPoses, RefuseJointsOutOfOrder) {
  RobotSpec robot = crane();
  std::swap(robot.joints[0], robot.joints[1]);
  EXPECT_THROW((void)link_poses(robot, {}), InputError);
}

TEST(LeafLinks, CarryNoOther) { EXPECT_THAT(leaf_links(crane()), testing::ElementsAre(2U)); }

}  // namespace
}  // namespace thenar
