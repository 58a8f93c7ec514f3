#pragma once

/// Postures of GraspIt! robots, as its worlds write them.

#include <map>
#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// Where a world's robot stands, and what about it cannot be kept.
struct GraspitPosture {
  std::map<std::string, double> values;  // degree of freedom, or joint -> [rad] or [m]
  std::vector<std::string> warnings;
};

/// The posture that <dofValues> tell of a robot. Degree of freedom by degree of freedom, in the
/// robot's order:
///   q              of a rigid or compliant one
///   q f1 f2 ..     of a breakaway one, with one f for each of its joints: "0" of a joint that its
///                  clutch holds, "1 v" of one that has broken away where the motor stood at v
/// in rad where its first joint turns, in mm where it slides. A joint is at ratio * q, or, broken
/// away, at ratio * min(q, v). Breakaway ones without any flags are read as well, where that makes
/// the count right. Values beyond limits are put on them, with a warning unless it is rounding of
/// the file. No value stands for zeros.
/// @param numbers  as in the file [1, rad, mm]
/// @return no values, and a warning, if the count fits neither way.
/// Source: [GraspItWorld] for the format.
[[nodiscard]] GraspitPosture graspit_posture(const RobotSpec& robot,
                                             const std::vector<double>& numbers);

}  // namespace thenar
