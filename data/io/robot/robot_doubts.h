#pragma once

/// Doubtful values in a robot that was read: numbers of another unit, joints that cannot move,
/// placeholders.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// Returns doubts about a robot of any file, one sentence each: shapes and offsets of joints beyond
/// 10 m, "a box of link 'palm' .."; hinges that turn by more than two turns; slides that move by
/// more than 1 m; driven joints whose range is a point.
[[nodiscard]] std::vector<std::string> robot_doubts(const RobotSpec& robot);

/// Returns doubts about links that have shapes and no mass, except the base, where others have one,
/// or that no link has: nothing for a grasp, but wrong in motion.
[[nodiscard]] std::vector<std::string> mass_doubts(const RobotSpec& robot);

/// Marks efforts that no hand's motors have as a model's placeholders, RobotDof::nominal_effort:
/// where all degrees of freedom have one, and all are 100 N m, or 1000 N, and more, and equal or
/// multiples of ten; and such a multiple at several hinges, or slides, 20 times those of all
/// others. Warns of them, and of efforts of 0 that no warning names.
void doubt_efforts(RobotSpec& robot);

}  // namespace thenar
