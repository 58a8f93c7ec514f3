#pragma once

/// How a robot hand closes and goes at things, found by trying it on a ball.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// What is known beforehand.
struct StatedClosing {
  bool closing = false;   // speeds of motors say which way closes
  bool approach = false;  // the robot's approach
};

/// A guess, written into `robot`: RobotDof::speed and ::open, and the approach.
struct InferredClosing {
  RobotSpec robot;
  double ball = 0;                   // radius of the ball that it was tried on [m]
  std::vector<std::string> idle;     // digits that do not touch it
  std::string thumb;                 // the one digit that is opposed to three or more; empty: none
  std::vector<std::string> closing;  // motors that close, each with its way: "d1 upwards"
  std::vector<std::string> set;      // motors that stand elsewhere than at 0 as closing begins
};

/// Tries ways of closing on a ball of 70 mm (of hands much larger or smaller than a human one, of
/// 0.7 times the length of a finger) and takes the one in which digits best face each other across
/// it.
///
/// Of every digit, motors about axes within 45 deg of its last joint's curl it, all the same way
/// round; the others turn it. It curls the way in which it has more range, or comes nearer to the
/// other digits; where ranges and nearness disagree both are tried. Digits whose tips go the same
/// way are the fingers; others, and one that turns much farther than the rest, are opposed to them:
/// their turning motors are tried over their whole ranges, and stand at the best place
/// (RobotDof::open). All other motors stand still. Where digits curl at each other, outer joints
/// may begin as far open as they go, so that ends do not meet first.
///
/// The hand goes at things along the way of its fingers' tips as they begin to curl, which is the
/// normal of its palm; or, where digits stand round a palm and curl against each other, from the
/// middle of the palm's box to their half-closed ends.
///
/// The score of a way of closing is
///   mean over digits of  max over others of  -n_i . n_j,  n the normals where they touch the ball
/// (others: digits, and the palm where digits curl at each other), plus that of the best pair of a
/// finger and an opposed digit, for three sizes of the ball, less what speaks against it in the
/// ranges. Surfaces are points (BallGrasp): no solids are built.
/// @param robot  with digits, at least one
[[nodiscard]] InferredClosing infer_closing(const RobotSpec& robot, const StatedClosing& known);

}  // namespace thenar
