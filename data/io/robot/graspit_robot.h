#pragma once

/// Robots in GraspIt! XML.

#include <string>

#include "data/io/robot/robot.h"

namespace thenar {

/// Reads a GraspIt! robot: palm, degrees of freedom "d0", "d1".. (rigid, breakaway, compliant),
/// chains of Denavit-Hartenberg joints, links of one to three joints (with links without mass
/// between them), and the approach. A joint's angle is  ratio * d + offset  and its limits hold for
/// ratio * d, so that the offset is part of the frames here; the range of a degree of freedom is
/// the intersection of its joints' ranges. Bodies are searched in iv/ beside the file, then beside
/// it. `warnings` lists what is not read.
/// @throws DataError `path:line: ..`
/// Source: [GraspIt] for the format.
[[nodiscard]] RobotSpec read_graspit_robot(const std::string& path);

}  // namespace thenar
