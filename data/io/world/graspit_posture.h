#pragma once

/// Postures of robots in GraspIt! worlds.

#include <map>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// Posture of a robot, with warnings about values that cannot be kept.
struct GraspitPosture {
  std::map<std::string, double> values;  // degree of freedom, or joint -> [rad] or [m]
  std::vector<std::string> warnings;
};

/// Reads the posture in <dofValues> of a robot, for each degree of freedom in the robot's order:
///   q              for a rigid or compliant one
///   q f1 f2 ..     for a breakaway one, with a flag f for each of its joints: "0" if its clutch
///   holds,
///                  "1 v" if it broke away when the motor stood at v
/// in rad if its first joint turns, in mm if it slides. A joint stands at ratio * q, or, broken
/// away, at ratio * min(q, v). Breakaway ones without flags are read as well, if the count is then
/// right. Values beyond limits are put on them, with a warning unless it is rounding of the file.
/// Missing values are zero.
/// @param numbers  as in the file [1, rad, mm]
/// @returns no values, and a warning, if the count fits neither way.
/// Source: [GraspItWorld] for the format.
[[nodiscard]] GraspitPosture graspit_posture(const RobotSpec& robot,
                                             const std::vector<double>& numbers);

}  // namespace thenar
