#pragma once

/// Jaws of one motor, and a cube for them.

#include "tests/grasp/closing_samples.h"

namespace thenar::sample {

/// Two jaws that stand on the x axis at -50 and 50 mm and slide towards each other.
inline RobotSpec sliding_jaws(const ShapeSpec& left, const ShapeSpec& right,
                              const std::string& material) {
  RobotSpec robot;
  robot.name = "jaws";
  robot.links.resize(3);
  robot.links[0].name = "base";
  for (const int side : {-1, 1}) {
    RobotLink& jaw = robot.links[side < 0 ? 1 : 2];
    jaw.name = side < 0 ? "left" : "right";
    jaw.material = material;
    jaw.shapes = {side < 0 ? left : right};
    RobotJoint joint = hinge(jaw.name, "base", jaw.name, {side * 0.05, 0, 0}, "motor", 1);
    joint.kind = RobotJointKind::kPrismatic;
    joint.axis = {-1.0 * side, 0, 0};
    joint.upper = 0.05;
    robot.joints.push_back(joint);
  }
  robot.dofs = {motor("motor", DriveCoupling::kRigid, 0.01)};
  robot.dofs[0].upper = 0.05;
  return robot;
}

/// The same as plates of 20 x 40 mm, of rubber, that go at things along y.
inline RobotSpec plates() {
  const auto plate = [](double x) { return shape(ShapeKind::kBox, {0.01, 0.04, 0.02}, {x, 0, 0}); };
  RobotSpec robot = sliding_jaws(plate(-0.005), plate(0.005), "rubber");
  robot.approach.direction = {0, 1, 0};
  return robot;
}

/// The same before a palm, with what the motor can do.
inline RobotSpec jaws() {
  RobotSpec robot = plates();
  robot.links[0].material = "rubber";
  robot.links[0].shapes = {shape(ShapeKind::kBox, {0.1, 0.01, 0.02}, {0, -0.03, 0})};
  for (RobotLink* jaw : {&robot.links[1], &robot.links[2]}) jaw->digit = jaw->name;
  robot.dofs[0].max_effort = 2;
  return robot;
}

inline ShapeSpec jaw_cube() { return shape(ShapeKind::kBox, {0.03, 0.03, 0.03}); }

}  // namespace thenar::sample
