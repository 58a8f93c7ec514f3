#pragma once

/// Small hands and bodies for tests of closing, whose contacts can be worked out by hand.

#include <string>
#include <vector>

#include "base/units.h"
#include "data/io/robot/robot.h"
#include "data/io/world/world.h"
#include "grasp/closing/setup.h"

namespace thenar::sample {

inline constexpr double kLength = 0.05;  // of a phalanx [m]
inline constexpr double kRadius = 0.008;

inline ShapeSpec shape(ShapeKind kind, const Eigen::Vector3d& size,
                       const Eigen::Vector3d& at = {0, 0, 0}) {
  ShapeSpec spec;
  spec.kind = kind;
  spec.size = size;
  spec.X_BS.p = at;
  return spec;
}

/// A capsule from the link's origin along its x axis.
inline RobotLink phalanx(const std::string& name, const std::string& digit) {
  RobotLink link;
  link.name = name;
  link.digit = digit;
  link.material = "rubber";
  ShapeSpec capsule = shape(ShapeKind::kCapsule, {kRadius, kLength, 0}, {kLength / 2, 0, 0});
  capsule.X_BS.R = rotation_about<double>(Eigen::Vector3d::UnitY(), kPi / 2);
  link.shapes = {capsule};
  return link;
}

inline RobotJoint hinge(const std::string& name, const std::string& parent,
                        const std::string& child, const Eigen::Vector3d& at, const std::string& dof,
                        double ratio) {
  RobotJoint joint;
  joint.name = name;
  joint.parent = parent;
  joint.child = child;
  joint.X_PJ.p = at;
  joint.lower = 0;
  joint.upper = kPi / 2;
  joint.dof = dof;
  joint.ratio = ratio;
  return joint;
}

inline RobotDof motor(const std::string& name, DriveCoupling kind, double speed = 1) {
  RobotDof dof;
  dof.name = name;
  dof.kind = kind;
  dof.upper = kPi / 2;
  dof.speed = speed;
  return dof;
}

/// Two phalanges along x that flex about z towards y, the outer one half as fast.
inline RobotSpec finger(DriveCoupling kind) {
  RobotSpec robot;
  robot.name = "finger";
  robot.links = {{}, phalanx("proximal", "finger"), phalanx("distal", "finger")};
  robot.links[0].name = "base";
  robot.joints = {hinge("knuckle", "base", "proximal", {0, 0, 0}, "motor", 1),
                  hinge("middle", "proximal", "distal", {kLength, 0, 0}, "motor", 0.5)};
  robot.dofs = {motor("motor", kind)};
  return robot;
}

/// Two fingers of one phalanx that stand on the x axis at -gap / 2 and +gap / 2, point along y and
/// flex towards each other.
inline RobotSpec pincer(double gap) {
  RobotSpec robot;
  robot.name = "pincer";
  robot.links = {{}, phalanx("left", "left"), phalanx("right", "right")};
  robot.links[0].name = "base";
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0 ? "left" : "right";
    RobotJoint joint = hinge(name + " knuckle", "base", name, {side * gap / 2, 0, 0}, name, 1);
    joint.X_PJ.R = rotation_about<double>(Eigen::Vector3d::UnitZ(), kPi / 2);
    joint.axis = {0, 0, side};
    robot.joints.push_back(joint);
    robot.dofs.push_back(motor(name, DriveCoupling::kRigid));
  }
  robot.approach.direction = {0, 1, 0};
  return robot;
}

inline PlacedBody placed(const std::string& name, const ShapeSpec& shape, const Eigen::Vector3d& at,
                         bool dynamic = true) {
  PlacedBody body;
  body.body.name = name;
  body.body.material = "wood";
  body.body.shapes = {shape};
  body.X_WB.p = at;
  body.dynamic = dynamic;
  return body;
}

inline GraspSetup setup(const std::vector<PlacedBody>& bodies) {
  WorldSpec world;
  world.name = "sample";
  world.bodies = bodies;
  return build_setup(world);
}

}  // namespace thenar::sample
