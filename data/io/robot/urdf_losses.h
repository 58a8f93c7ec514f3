#pragma once

/// Properties of a robot that URDF cannot express, and the couplings that replace them.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar::internal {

/// Returns a warning for each property of a robot that URDF has no words for.
[[nodiscard]] std::vector<std::string> losses_in_urdf(const RobotSpec& robot);

/// Returns the joint that represents a motor: the first with ratio 1 and no offset, otherwise the
/// first, if possible one that follows no curve. @param dof  moves a joint
[[nodiscard]] const RobotJoint& leader_of(const RobotSpec& robot, const std::string& dof);

/// A linear coupling  joint = ratio motor + offset.
struct CouplingLine {
  double ratio, offset;
  double off = 0;  // largest deviation from the curve [rad] or [m]
};

/// Returns the linear coupling of a joint; for a curve the line parallel to its chord with the
/// smallest largest deviation.
[[nodiscard]] CouplingLine line_of(const RobotSpec& robot, const RobotJoint& joint);

}  // namespace thenar::internal
