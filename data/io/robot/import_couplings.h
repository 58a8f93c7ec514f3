#pragma once

/// Couplings of joints that follow joints, as shared degrees of freedom.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar::internal {

/// Value of `joint` = offset + ratio v + curve_0 v^2 + .., with v the value of `master`.
struct FollowerCoupling {
  std::string joint;
  std::string master;
  double ratio = 1;                // [1], [m/rad] or [rad/m]
  double offset = 0;               // [rad] or [m]
  int line = 1;                    // line in the file, for messages
  std::vector<double> curve = {};  // empty: linear
};

/// Gives every moving joint that follows none a degree of freedom of its own name (rigid, speed 1),
/// which all joints that follow it, also through others, share. If a follower would leave its
/// limits, the range becomes the tightest one, with a warning; if nothing would be left, the
/// follower's limits are widened instead.
/// @throws DataError with `path` for couplings to unknown joints, in a circle, or through others
/// along a polynomial of a degree above 16.
void couple_joints(RobotSpec& robot, const std::vector<FollowerCoupling>& couplings,
                   const std::string& path);

/// An interval of joint values.
struct JointRange {
  double lower, upper;  // [rad] or [m]
};

/// Returns the interval of the degree of freedom that keeps a joint, which follows it linearly,
/// within its limits.
[[nodiscard]] JointRange range_through(const RobotJoint& joint);

/// Widens the limits of a joint by its excess over the range of the degree of freedom that it
/// follows, evaluated at the given number of intervals.
void widen_limits(RobotJoint& joint, const RobotDof& dof, int intervals);

/// Sorts joints so that parents come before children, and puts the base link first; children of one
/// parent keep their order.
/// @throws DataError with `path` if there is not exactly one link that no joint carries, or a ring.
void order_tree(RobotSpec& robot, const std::string& path);

}  // namespace thenar::internal
