#pragma once

/// Robots from MJCF, the format of MuJoCo.

#include <string>

#include "data/io/robot/robot.h"

namespace thenar {

/// Reads an MJCF model: bodies, inertials (or masses from geoms), joints, geoms, defaults, included
/// files; joint equalities and equalities of fixed tendons as rigid couplings, fixed tendons with
/// an actuator as compliant ones. Joints that nothing couples are degrees of freedom of their own;
/// the largest force of an actuator becomes their effort. Several joints of a body get links
/// without mass between them. The base is the one body on top if it stands at the world's origin
/// and does not move, else a link "world". Joint values are MuJoCo's qpos: zero is zero. What is
/// not read (sites, sensors, closed loops, spatial tendons, planes..) is in `warnings`.
/// @throws DataError `path:line: ..`
/// Source: [Todorov2012].
[[nodiscard]] RobotSpec read_mjcf(const std::string& path);

}  // namespace thenar
