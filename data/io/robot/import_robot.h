#pragma once

/// Robots from files of any kind.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

enum class RobotFileKind { kToml, kUrdf, kMjcf, kGraspit };

/// "thenar TOML", "URDF", "MJCF", "GraspIt! XML".
[[nodiscard]] std::string name_of(RobotFileKind kind);

/// What a file of robots is, by what it holds: <mujoco>; <robot> with <link> or <joint> children
/// for URDF, with <palm>, <chain> or <dof> for GraspIt!; otherwise TOML.
/// @throws DataError if it is XML of none of these kinds.
[[nodiscard]] RobotFileKind find_robot_kind(const std::string& path);

/// Reads a robot of any kind. What was not understood is in its `warnings`. Inertias that no body
/// has (a principal moment above the sum of the others, or below 0) are cut to the nearest that one
/// has, meshes that bound no solid are mended (repair_to_solid()) or, where they are flat, left
/// out: each with a warning.
/// @throws DataError  `path:line: ..`
[[nodiscard]] RobotSpec import_robot(const std::string& path);

}  // namespace thenar

namespace thenar::internal {

// Warnings of imports, put in order.

/// The same one once, with " (N times)"; first what is missing or unreadable (in capitals: MISSING,
/// UNREADABLE, INCOMPLETE, LEFT OUT), then what was changed, last elements that are not read, as
/// gains and colours.
[[nodiscard]] std::vector<std::string> by_severity(const std::vector<std::string>& warnings);

}  // namespace thenar::internal
