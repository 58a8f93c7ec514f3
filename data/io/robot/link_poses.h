#pragma once

/// Poses of a robot's links.

#include <map>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// Values of degrees of freedom by name [rad] or [m]; missing ones are 0.
using DofValues = std::map<std::string, double>;

/// Returns the value of a joint at value u of its degree of freedom:
///   offset + ratio u + curve_0 u^2 + curve_1 u^3 + ..
[[nodiscard]] double joint_value(const RobotJoint& joint, double u);

/// Returns the value of a joint; an undriven joint is at its offset.
[[nodiscard]] double joint_value(const RobotJoint& joint, const DofValues& dofs);

/// Returns the motion of a joint by a value: a rotation about its axis, or a translation along it.
[[nodiscard]] Pose<double> joint_motion(const RobotJoint& joint, double value);

/// Returns the poses of all links in the base, in the order of `links`:
///   X_BC = X_BP X_PJ motion(axis, value) X_JC.
/// @throws InputError if a joint comes before the joint that carries its parent.
[[nodiscard]] std::vector<Pose<double>> link_poses(const RobotSpec& robot, const DofValues& dofs);

/// Returns the links that carry no other, as indices into `links`.
[[nodiscard]] std::vector<std::size_t> leaf_links(const RobotSpec& robot);

}  // namespace thenar
