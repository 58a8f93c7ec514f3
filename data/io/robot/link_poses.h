#pragma once

/// Where the links of a described robot are.

#include <map>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// Values of degrees of freedom by name [rad] or [m]; those left out are at 0.
using DofValues = std::map<std::string, double>;

/// Value of a joint where its degree of freedom is at u, and how it changes with u:
///   offset + ratio u + curve_0 u^2 + curve_1 u^3 + ..
[[nodiscard]] double joint_value(const RobotJoint& joint, double u);
[[nodiscard]] double joint_slope(const RobotJoint& joint, double u);

/// Value of a joint; the offset alone if nothing drives it.
[[nodiscard]] double joint_value(const RobotJoint& joint, const DofValues& dofs);

/// Motion of a joint by a value: a turn about its axis, or a way along it.
[[nodiscard]] Pose<double> joint_motion(const RobotJoint& joint, double value);

/// Poses of all links in the base, in the order of `links`:
///   X_BC = X_BP X_PJ motion(axis, value) X_JC.
/// @throws InputError if a joint stands before the one that carries its parent.
[[nodiscard]] std::vector<Pose<double>> link_poses(const RobotSpec& robot, const DofValues& dofs);

/// Links that carry no other, as indices into `links`.
[[nodiscard]] std::vector<std::size_t> leaf_links(const RobotSpec& robot);

}  // namespace thenar
