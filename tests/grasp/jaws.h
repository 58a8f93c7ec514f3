#pragma once

/// Jaws of one motor, and a cube for them.

#include "tests/grasp/closing_samples.h"

namespace thenar::sample {

/// Two plates of 20 x 40 mm that stand on the x axis and slide towards each other from 100 mm,
/// before a palm.
inline RobotSpec jaws() {
  RobotSpec robot;
  robot.name = "jaws";
  robot.links.resize(3);
  robot.links[0].name = "base";
  robot.links[0].material = "rubber";
  robot.links[0].shapes = {shape(ShapeKind::kBox, {0.1, 0.01, 0.02}, {0, -0.03, 0})};
  for (const int side : {-1, 1}) {
    RobotLink& jaw = robot.links[side < 0 ? 1 : 2];
    jaw.name = side < 0 ? "left" : "right";
    jaw.digit = jaw.name;
    jaw.material = "rubber";
    jaw.shapes = {shape(ShapeKind::kBox, {0.01, 0.04, 0.02}, {side * 0.005, 0, 0})};
    RobotJoint joint = hinge(jaw.name, "base", jaw.name, {side * 0.05, 0, 0}, "motor", 1);
    joint.kind = RobotJointKind::kPrismatic;
    joint.axis = {-1.0 * side, 0, 0};
    joint.upper = 0.05;
    robot.joints.push_back(joint);
  }
  robot.dofs = {motor("motor", RobotDofKind::kRigid, 0.01)};
  robot.dofs[0].upper = 0.05;
  robot.dofs[0].max_effort = 2;
  robot.approach.direction = {0, 1, 0};
  return robot;
}

inline ShapeSpec jaw_cube() { return shape(ShapeKind::kBox, {0.03, 0.03, 0.03}); }

}  // namespace thenar::sample
