#pragma once

/// Completion of a robot description for grasping: materials, digits, closing and approach.

#include "data/io/robot/robot.h"
#include "data/io/world/materials.h"

namespace thenar {

/// Assigns materials to links that have shapes and no material: rubber if their names contain
/// silicone, rubber or elastomer, otherwise kDefaultMaterial; warnings name them.
[[nodiscard]] RobotSpec with_materials(RobotSpec robot);

/// Checks that a robot has no unsolved loops (RobotSpec::open_loops), whose parts would separate.
/// @throws InputError that names the loops
void require_closed_loops(const RobotSpec& robot);

/// Makes a robot ready for grasps: with_materials() and, for a robot with joints whose shapes form
/// a hand:
///
/// digits: by infer_digits(), if no link has one and no approach is stated. A digit that is opposed
///   to three or more is called "thumb".
/// closing, if it is not stated or every speed is 0, and the approach, if it is not stated: by
///   infer_closing().
///
/// The warnings list each inference, the digits that touch nothing with it, and nominal efforts.
/// Lengths in [m], angles in [rad].
/// @throws InputError as require_closed_loops(), RobotHand.
[[nodiscard]] RobotSpec graspable(RobotSpec robot);

/// Infers the digits of links with shapes. A digit is a branch of moving joints that ends in a
/// leaf, back to the point at which another branch leaves. Branches that a loop joins are one
/// digit; links without a moving joint between them are one body; branches without any shape do not
/// count. A digit is named after the finger that most of its links are named after, otherwise
/// "finger N".
/// @returns the number of digits
int infer_digits(RobotSpec& robot);

}  // namespace thenar
