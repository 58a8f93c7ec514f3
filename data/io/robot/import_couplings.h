#pragma once

/// From joints that follow joints to degrees of freedom.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar::internal {

/// Value of `joint` = offset + ratio v + curve_0 v^2 + .., with v the value of `master`.
struct FollowerCoupling {
  std::string joint;
  std::string master;
  double ratio = 1;           // [1], [m/rad] or [rad/m]
  double offset = 0;          // [rad] or [m]
  int line = 1;               // of the file that says so
  std::vector<double> curve;  // empty: linear
};

/// Gives every moving joint that follows none a degree of freedom of its own name (rigid, speed 1),
/// and lets those that follow it, also through others, share it. Where a follower would leave its
/// limits the range becomes the tightest one, and a warning says so; where nothing would be left
/// the follower's limits are widened instead.
/// @throws DataError with `path` for couplings to unknown joints, round in a ring, or through
/// others along a polynomial of a degree above 16.
void couple_joints(RobotSpec& robot, const std::vector<FollowerCoupling>& couplings,
                   const std::string& path);

/// A range of values.
struct JointRange {
  double lower, upper;  // [rad] or [m]
};

/// Values of the degree of freedom that keep one joint, which follows it linearly, within its
/// limits.
[[nodiscard]] JointRange range_through(const RobotJoint& joint);

/// The joint of that name, or none.
[[nodiscard]] RobotJoint* find_joint(RobotSpec& robot, const std::string& name);
[[nodiscard]] RobotDof* find_dof(RobotSpec& robot, const std::string& name);

/// Puts joints in an order in which parents come before children, and the base link first; those of
/// one parent keep their order.
/// @throws DataError with `path` if there is not exactly one link that no joint carries, or a ring.
void order_tree(RobotSpec& robot, const std::string& path);

}  // namespace thenar::internal
