#pragma once

/// Reads robots from files of any kind.

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "data/io/robot/robot.h"

namespace thenar {

/// Kind of a robot file.
enum class RobotFileKind { kToml, kUrdf, kMjcf, kGraspit };
inline constexpr std::array kRobotFileKindNames{
    EnumName{RobotFileKind::kToml, "thenar TOML"}, EnumName{RobotFileKind::kUrdf, "URDF"},
    EnumName{RobotFileKind::kMjcf, "MJCF"}, EnumName{RobotFileKind::kGraspit, "GraspIt! XML"}};
[[nodiscard]] inline std::string name_of(RobotFileKind kind) {
  return name_in(kRobotFileKindNames, kind);
}

/// Finds the kind of a robot file by its content: <mujoco>; <robot> with <link> or <joint> children
/// for URDF, with <palm>, <chain> or <dof> for GraspIt!; otherwise TOML.
/// @throws DataError if it is XML of none of these kinds.
[[nodiscard]] RobotFileKind find_robot_kind(const std::string& path);

/// Reads a robot of any kind. `warnings` lists what was not understood, and each repair: impossible
/// inertias (a principal moment above the sum of the others, or below 0) are replaced by the
/// nearest possible one; meshes that bound no solid are repaired (repair_to_solid()) or, if they
/// are flat, left out.
/// @throws DataError  `path:line: ..`
[[nodiscard]] RobotSpec import_robot(const std::string& path);

/// Returns true if a warning says that the robot is not the intended one: parts are missing or
/// unreadable, its lengths or angles are in another unit, or joints cannot move.
[[nodiscard]] bool is_serious(const std::string& warning);

/// Returns true if a warning says that a file of the robot is missing.
[[nodiscard]] bool names_missing_part(const std::string& warning);

/// Returns true if the warnings of a robot contain a warning already, possibly with a count.
[[nodiscard]] bool contains_warning(const std::vector<std::string>& warnings,
                                    const std::string& doubt);

}  // namespace thenar

namespace thenar::internal {

/// Sorts warnings, each once with " (N times)": first missing or unreadable parts (in capitals:
/// MISSING, UNREADABLE, INCOMPLETE, LEFT OUT), then changes, last elements that are not read, like
/// gains and colours.
[[nodiscard]] std::vector<std::string> by_severity(const std::vector<std::string>& warnings);

}  // namespace thenar::internal
