#pragma once

/// Robots from URDF.

#include <string>

#include "data/io/robot/robot.h"

namespace thenar {

/// Reads a URDF: links, inertials, collision shapes (visual ones where a link has no other),
/// joints, limits, dynamics and mimic joints, also mimics of mimics. Every moving joint that mimics
/// none is a degree of freedom; its speed is the joint's velocity limit, taken as relative,
/// downwards where its range lies below zero. A continuous joint gets one turn. Floating and planar
/// joints stay where they are. What is not read (transmissions, colours, sensors..) and what is
/// missing (mesh files) is in `warnings`.
/// @throws DataError `path:line: ..` for what is no URDF, and for xacro, which must be expanded
/// first.
[[nodiscard]] RobotSpec read_urdf(const std::string& path);

}  // namespace thenar
