#pragma once

/// A gripper of four-bar linkages.

#include "tests/grasp/closing_samples.h"

namespace thenar::sample {

/// A gripper of two parallelograms as URDF has them: on each side a knuckle of 57 mm carries the
/// finger, which turns back as far, and a bar nearer to the middle, `off` beside both [m], follows
/// by itself.
inline RobotSpec four_bars(double off) {
  RobotSpec robot;
  robot.name = "four bars";
  robot.closing_stated = robot.approach_stated = false;
  robot.links.resize(1);
  robot.links[0].name = "base";
  robot.links[0].shapes = {shape(ShapeKind::kBox, {0.03, 0.07, 0.06}, {0, 0, 0.03})};
  const auto add = [&](const std::string& name, const std::string& parent,
                       const Eigen::Vector3d& at, double ratio, const ShapeSpec& solid) {
    RobotLink link;
    link.name = name;
    link.shapes = {solid};
    robot.links.push_back(link);
    robot.joints.push_back(hinge(name, parent, name, at, "motor", ratio));
    robot.joints.back().axis = Eigen::Vector3d::UnitX();
    robot.joints.back().lower = -0.8;
    robot.joints.back().upper = 0.8;
  };
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "left " : "right ";
    const Eigen::Vector3d bar(0, side * 0.037, 0.043);
    ShapeSpec along = shape(ShapeKind::kBox, {0.008, 0.008, bar.norm()}, bar / 2);
    along.X_BS.R = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), bar.normalized())
                       .toRotationMatrix();
    add(name + "knuckle", "base", {0, side * 0.031, 0.055}, side, along);
    add(name + "finger", name + "knuckle", bar, -side,
        shape(ShapeKind::kBox, {0.02, 0.012, 0.06}, {0, -side * 0.018, 0.03}));
    add(name + "bar", "base", {off, side * 0.013, 0.061}, side, along);
  }
  robot.dofs = {motor("motor", DriveCoupling::kRigid)};
  robot.dofs[0].upper = 0.8;
  return robot;
}

}  // namespace thenar::sample
