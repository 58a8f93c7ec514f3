#pragma once

/// Robots from files of any kind.

#include <string>

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
/// has, meshes that bound no solid are mended (mend_mesh()) or, where they are flat, left out: each
/// with a warning.
/// @throws DataError  `path:line: ..`
[[nodiscard]] RobotSpec import_robot(const std::string& path);

}  // namespace thenar
