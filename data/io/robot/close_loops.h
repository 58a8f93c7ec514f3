#pragma once

/// Linkages that close loops, as couplings of the joints in a tree.

#include <set>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar::internal {

/// Two places that are one: points of two links, and their directions where the joint is stiff.
struct LoopClosure {
  std::string a, b;       // links
  Pose<double> X_A, X_B;  // the place in each
  bool welded = false;    // false: a ball joint, which leaves directions free
  std::string words;      // "<connect> of 'a' and 'b'"
};

/// Turns joints that loops hold into followers of the motor that drives their loop.
///
/// Over the motor's range passive joints are solved for so that the loop closes,
///   min  sum of  k (y - rest)^2 / 2   so that  c(u, y) = 0,  lower <= y <= upper,
/// with k and rest of their springs, which only count where a loop leaves more than one freedom (an
/// adaptive gripper, whose spring holds a link at its stop). Their values become polynomials of the
/// motor's, RobotJoint::curve. These are checked at 500 places: nowhere does the loop gape by more
/// than 0.05 mm, or else it counts as unsolved. A joint that does not move in the loop stands
/// still. Where the loop closes in a part of the motor's range only, that part (a fifth or more of
/// it) remains.
///
/// What is solved is in the robot's warnings, with how far it gapes; what is not (several motors or
/// none, a freedom that no spring decides, no closed posture) is in RobotSpec::open_loops.
/// @param driven  degrees of freedom with a motor; empty: the first one of each loop is
void close_loops(RobotSpec& robot, const std::vector<LoopClosure>& closures,
                 const std::set<std::string>& driven);

}  // namespace thenar::internal
