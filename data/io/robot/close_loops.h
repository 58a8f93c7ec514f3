#pragma once

/// Closed loops of linkages, turned into couplings of the joints of a tree.

#include <set>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar::internal {

/// A loop closure: two places on links that coincide, in position, or welded in rotation, too.
struct LoopClosure {
  std::string a, b;       // links
  Pose<double> X_A, X_B;  // the place in each link
  bool welded = false;    // false: a ball joint, which leaves rotations free
  std::string words;      // description for messages: "<connect> of 'a' and 'b'"
};

/// Turns joints in closed loops into followers of the motor that drives the loop.
///
/// Over the motor's range passive joints y are solved so that the loop closes,
///   min  sum of  k (y - rest)^2 / 2   so that  c(u, y) = 0,  lower <= y <= upper,
/// with k and rest of their springs, which only matter if a loop leaves more than one freedom (an
/// adaptive gripper whose spring holds a link at its stop). The solution becomes a polynomial of
/// the motor's value, RobotJoint::curve, checked at 500 places: if the loop gapes by more than 0.05
/// mm anywhere, it counts as unsolved. A joint that does not move in the loop is fixed. If the loop
/// closes in a part of the motor's range only, this part (at least a fifth) remains.
///
/// Solved loops are in the robot's warnings with their gap; unsolved ones (several motors or none,
/// a freedom that no spring determines, no closed posture) are in RobotSpec::open_loops.
/// @param driven  degrees of freedom with a motor; empty: the first of each loop has one
void close_loops(RobotSpec& robot, const std::vector<LoopClosure>& closures,
                 const std::set<std::string>& driven);

}  // namespace thenar::internal
