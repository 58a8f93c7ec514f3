#pragma once

/// Infers how a robot hand closes and approaches objects, by trying it on a ball.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// Facts about closing that the robot's own file states.
struct StatedClosing {
  bool closing = false;   // the speeds of motors say which way closes
  bool approach = false;  // the approach is stated
};

/// An inference, written into `robot`: RobotDof::speed and ::open, and the approach.
struct InferredClosing {
  RobotSpec robot;
  double ball = 0;                   // radius of the ball on which it was tried [m]
  bool facing = false;               // whether digits face each other, or the palm, across it
  std::vector<std::string> idle;     // digits that do not touch the ball
  std::string thumb;                 // the only digit opposed to three or more; empty: none
  std::vector<std::string> closing;  // motors that close, each with its sense: "d1 upwards"
  std::vector<std::string> set;      // motors that start closing elsewhere than at 0
};

/// Tries ways of closing on a ball of 70 mm (for hands much larger or smaller than a human one, of
/// 0.7 times the length of a finger) and takes the way in which digits best face each other across
/// the ball. Where no digits face each other in any way, as jaws of a short stroke, the ball is
/// halved up to four times; where they still do not, as jaws that stay apart, it is 1.5 to 3.4
/// times as large.
///
/// Digits that are curled where their motors stand at 0 are straightened first, as far as they go.
/// Motors about axes within 45 deg of the axis of a digit's last joint curl the digit, all in one
/// sense; its other motors turn it. It curls in the sense in which it has more range, or comes
/// nearer to the other digits; if ranges and nearness disagree, both are tried. Digits whose tips
/// move the same way are the fingers. Others, and a digit that turns much farther than the rest,
/// are opposed to them: their turning motors are tried over their whole ranges, and start at the
/// best position (RobotDof::open). All other motors stand still. Where digits curl at each other,
/// outer joints may begin as far open as they go, so that ends do not meet first. An only digit is
/// a jaw, and the sense in which its end comes nearer to the palm closes it.
///
/// The hand approaches objects along the direction in which its fingertips begin to curl, which is
/// the normal of its palm; or, where digits stand round a palm and curl against each other, from
/// the centre of the palm's box to their half-closed ends. An only digit goes along the part of the
/// palm on which it closes.
///
/// The score of a way of closing is
///   mean over digits of  max over others of  -n_i . n_j,  n the normals where they touch the ball
/// (others: digits, and the palm where digits curl at each other), plus the best pair of a finger
/// and an opposed digit, for three sizes of the ball, less the evidence against it from ranges
/// and nearness, at most 0.6, and less half of the sine by which a palm and fingers would push the
/// ball aside as it comes.
/// Surfaces are points (BallGrasp): no solids are built.
/// @param robot  with at least one digit
[[nodiscard]] InferredClosing infer_closing(const RobotSpec& robot, const StatedClosing& known);

}  // namespace thenar
