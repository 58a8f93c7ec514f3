#pragma once

/// Completes a robot that is to grasp: materials, digits, closing and approach.

#include "data/io/robot/robot.h"
#include "data/io/world/materials.h"

namespace thenar {

/// Gives links with shapes and without material kDefaultMaterial, those whose names speak of
/// silicone, rubber or elastomer rubber; warnings name them.
[[nodiscard]] RobotSpec with_materials(RobotSpec robot);

/// Refuses a robot with unsolved loops (RobotSpec::open_loops): its parts would come apart.
/// @throws InputError naming them
void require_closed_loops(const RobotSpec& robot);

/// Makes a robot able to grasp: with_materials(), and for a robot with joints whose shapes make a
/// hand:
///
/// digits: by infer_digits(), if no link has one and no approach is stated. A digit that is opposed
///   to three or more is called "thumb".
/// closing, if it is not stated or every speed is 0; and approach, if it is not stated: by
///   infer_closing().
///
/// The warnings list each inference, the digits that touch nothing with it, and the efforts that
/// are nominal. Lengths in [m], angles in [rad].
/// @throws InputError as require_closed_loops(), RobotHand.
[[nodiscard]] RobotSpec graspable(RobotSpec robot);

/// Infers the digits of links with shapes. A digit is a branch of moving joints that ends in a
/// leaf, as far back as no other branches off. Branches that a loop joins are one digit; links that
/// nothing moves against each other are one body; branches without any shape do not count. A digit
/// is named after the finger that most of its links are named after, otherwise "finger N".
/// @returns the number of digits
int infer_digits(RobotSpec& robot);

}  // namespace thenar
