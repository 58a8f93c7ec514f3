#pragma once

/// What formats without hands in mind leave unsaid of a robot that is to grasp.

#include "data/io/robot/robot.h"
#include "data/io/world/materials.h"

namespace thenar {

/// kDefaultMaterial for links with shapes and without a material; a warning names them.
[[nodiscard]] RobotSpec with_materials(RobotSpec robot);

/// Refuses a robot with loops that are not solved (RobotSpec::open_loops): what hangs on them would
/// come apart.
/// @throws InputError naming them
void require_closed_loops(const RobotSpec& robot);

/// A robot that can grasp: with_materials(), and, of one with joints whose shapes make a hand:
///
/// digits: by infer_digits(), where no link has one and no approach is stated. All that follows is
///   guessed then too. One that is opposed to three or more is called "thumb".
/// closing, where it is not stated, or every speed is 0; and approach, where it is not stated: by
///   infer_closing().
///
/// Each guess is in the warnings, which digits touch nothing with it, and which efforts are
/// nominal. [rad], [m].
/// @throws InputError as require_closed_loops(), RobotHand.
[[nodiscard]] RobotSpec graspable(RobotSpec robot);

/// Names the digit of links with shapes: a digit is a branch of moving joints that ends in a leaf,
/// as far back as no other branches off; branches that a loop holds together are one; links that
/// nothing moves against each other are one, and branches without any shape do not count. It is
/// called after the finger that a link of it is named after, else "finger N". @return how many
/// digits there are
int infer_digits(RobotSpec& robot);

}  // namespace thenar
