// Tests for data/io/robot/linkage.cpp: a slider-crank against its closed form.

#include "data/io/robot/linkage.h"

#include <cmath>

#include <gmock/gmock.h>

#include "base/units.h"

namespace thenar::internal {
namespace {

constexpr double kCrank = 0.03, kRod = 0.1;  // [m]

RobotJoint hinge_about_z(const std::string& name, const std::string& parent, double x) {
  RobotJoint joint;
  joint.name = joint.child = joint.dof = name;
  joint.parent = parent;
  joint.X_PJ.p = {x, 0, 0};
  joint.lower = -kPi;
  joint.upper = kPi;
  return joint;
}

/// A crank at the origin, a rod on its end, and a slider along x that the rod's end is to meet.
RobotSpec slider_crank() {
  RobotSpec robot;
  for (const char* name : {"base", "crank", "rod", "slider"}) {
    robot.links.emplace_back();
    robot.links.back().name = name;
  }
  RobotJoint slide = hinge_about_z("slider", "base", 0);
  slide.kind = RobotJointKind::kPrismatic;
  slide.axis = {1, 0, 0};
  slide.lower = 0;
  slide.upper = 1;
  robot.joints = {hinge_about_z("crank", "base", 0), hinge_about_z("rod", "crank", kCrank), slide};
  for (const RobotJoint& joint : robot.joints) {
    RobotDof dof;
    dof.name = joint.name;
    dof.lower = joint.lower;
    dof.upper = joint.upper;
    robot.dofs.push_back(dof);
  }
  return robot;
}

LoopGroup rod_on_slider() {
  LoopClosure closure;
  closure.a = "rod";
  closure.b = "slider";
  closure.X_A.p = {kRod, 0, 0};
  return {{closure}, {"crank", "rod", "slider"}};
}

// x = r cos u + sqrt(l^2 - r^2 sin^2 u); the rod turns back by u and asin(r sin u / l).
TEST(Linkage, ClosesASliderCrank) {
  const RobotSpec robot = slider_crank();
  const LoopGroup group = rod_on_slider();
  const Linkage linkage(robot, group, "crank");
  ASSERT_EQ(linkage.passives().size(), 2U);
  Eigen::VectorXd y(2);
  y << 0, kCrank + kRod;
  for (double u = 0; u < 2; u += 0.1) {
    const auto closed = linkage.close(u, y);
    ASSERT_TRUE(closed.has_value()) << u;
    y = *closed;
    const double s = kCrank * std::sin(u);
    EXPECT_NEAR(y[1], kCrank * std::cos(u) + std::sqrt(kRod * kRod - s * s), 1e-10) << u;
    EXPECT_NEAR(y[0], -u - std::asin(s / kRod), 1e-9) << u;
  }
}

TEST(Linkage, ResidualIsTheGap) {
  const RobotSpec robot = slider_crank();
  const LoopGroup group = rod_on_slider();
  const Linkage linkage(robot, group, "crank");
  const Eigen::VectorXd gap = linkage.loop_residual(0, Eigen::Vector2d(0, 0.05));
  EXPECT_NEAR((gap - Eigen::Vector3d(kCrank + kRod - 0.05, 0, 0)).norm(), 0, 1e-15);
}

TEST(Linkage, SaysWhenALimitKeepsItOpen) {
  RobotSpec robot = slider_crank();
  robot.dofs[2].upper = 0.12;  // [m]; closing at u = 0 needs 0.13
  const LoopGroup group = rod_on_slider();
  EXPECT_FALSE(Linkage(robot, group, "crank").close(0, Eigen::Vector2d(0, 0.1)).has_value());
}

}  // namespace
}  // namespace thenar::internal
