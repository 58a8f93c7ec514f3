#pragma once

/// What formats without hands in mind leave unsaid of a robot that is to grasp.

#include "data/io/robot/robot.h"
#include "data/io/world/materials.h"

namespace thenar {

/// kGuessedMaterial for links with shapes and without a material; a warning names them.
[[nodiscard]] RobotSpec with_materials(RobotSpec robot);

/// A robot that can grasp: with_materials(), and, of one with joints whose shapes make a hand:
///
/// digits: by guess_digits(), where no link has one and no approach is stated (it is [0, 0, 1] from
///   the origin, as where a format has none). All that follows is guessed then too.
/// closing, where it is not stated, or every speed is 0: drives run in the direction in which the
/// tips they move come nearer to the others, by
///   the sum of squared distances in a hundredth of their range from zero or the limit next to it;
///   where that hardly changes, to the farther limit. Joints that move all tips alike (wrists) and
///   those that turn a digit across the axis of its last joint (spreads) stay where they are.
/// approach, where neither it nor the closing is stated: from the middle of the palm's box to the
/// mean of the middles of the last links, with
///   every closing drive in the middle of its range; it begins where that line leaves the box.
///
/// Each guess is in the warnings, and which efforts are nominal. [rad], [m].
/// @throws InputError as RobotHand.
[[nodiscard]] RobotSpec graspable(RobotSpec robot);

/// Names the digit of links with shapes: a digit is a branch of moving joints that ends in a leaf,
/// as far back as no other branches off; branches that a loop holds together are one; links that
/// nothing moves against each other are one, and branches without any shape do not count. It is
/// called after the finger that a link of it is named after, else "finger N". @return how many
/// digits there are
int guess_digits(RobotSpec& robot);

}  // namespace thenar
