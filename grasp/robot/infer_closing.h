#pragma once

/// Inference of how a robot hand closes and approaches objects, by trials on a ball.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// Facts about closing that the robot's own file states.
struct StatedClosing {
  bool closing = false;   // whether the speeds of motors state the closing direction
  bool approach = false;  // whether the approach is stated
};

/// Inferred closing; it is also written into `robot`: RobotDof::speed and ::open, and the approach.
struct InferredClosing {
  RobotSpec robot;
  double ball = 0;                   // radius of the ball of the trials [m]
  bool facing = false;               // whether digits face each other, or the palm, across it
  std::vector<std::string> idle;     // digits that do not touch the ball
  std::string thumb;                 // the only digit opposed to three or more; empty: none
  std::vector<std::string> closing;  // motors that close, each with its direction: "d1 upwards"
  std::vector<std::string> set;      // motors that start closing at a value other than 0
};

/// Tries combinations of closing directions on a ball of 70 mm (for hands much larger or smaller
/// than a human one, of 0.7 times the length of a finger) and selects the one in which digits best
/// face each other across the ball. If no digits face each other in any of them, as for jaws with a
/// short stroke, the ball is halved up to four times; if they still do not, as for jaws that stay
/// apart, it is 1.5 to 3.4 times as large.
///
/// Digits that are curled where their motors are at 0 are straightened first, as far as possible.
/// Motors about axes within 45 deg of the axis of a digit's last joint curl the digit, all in one
/// direction; its other motors turn it. It curls in the direction in which it has more range, or
/// comes nearer to the other digits; if ranges and distances disagree, both are tried. Digits whose
/// tips move in the same direction are the fingers. Others, and a digit that turns much farther
/// than the rest, are opposed to them: their turning motors are tried over their whole ranges, and
/// start at the best position (RobotDof::open). All other motors do not move. Where digits curl
/// towards each other, outer joints may start as far open as possible, so that the tips do not meet
/// first. A single digit is a jaw, which closes in the direction that brings its end nearer to the
/// palm.
///
/// The hand approaches objects along the direction in which its fingertips begin to curl, which is
/// the normal of its palm; or, if digits surround a palm and curl against each other, from the
/// centre of the palm's box towards their half-closed tips. A hand with a single digit approaches
/// along the part of the palm on which the digit closes.
///
/// The score of a combination is
///   mean over digits of  max over others of  -n_i . n_j,  n the normals where they touch the ball
/// (others: digits, and the palm where digits curl towards each other), plus the best pair of a
/// finger and an opposed digit, for three sizes of the ball, less the evidence against it from
/// ranges and distances, at most 0.6, and less half of the sine by which a palm and fingers would
/// push the ball aside during the approach. Surfaces are points (BallGrasp): no solids are built.
/// @param robot  with at least one digit
[[nodiscard]] InferredClosing infer_closing(const RobotSpec& robot, const StatedClosing& known);

}  // namespace thenar
