#pragma once

/// Readers of single tables of a scene.

#include "data/io/scene/scene.h"
#include "data/io/toml_table.h"

namespace thenar::internal {

/// Reads [body.joint] or [hand.joint]. @param kind  default kind
[[nodiscard]] SceneJointSpec read_scene_joint(TomlTable& owner, JointKind kind);
/// Reads `velocity` and `angular_velocity`, which only free bodies may have.
[[nodiscard]] SceneVelocity read_scene_velocity(TomlTable& owner, JointKind kind);
[[nodiscard]] SceneForceSpec read_scene_force(TomlTable& table);
/// @param folder  of the scene
[[nodiscard]] SceneDriveSpec read_scene_drive(TomlTable& table, const std::string& folder);
/// Reads [[tendon]] or [[muscle]]. @param tensions  true: [[tendon]];  @param folder  folder of the
/// scene
[[nodiscard]] SceneMuscleSpec read_scene_muscle(TomlTable& table, bool tensions,
                                                const std::string& folder);
[[nodiscard]] SceneFrictionSpec read_scene_friction(TomlTable& table);
[[nodiscard]] SceneApartSpec read_scene_apart(TomlTable& table);
[[nodiscard]] SteppingSpec read_stepping(TomlTable& table);

}  // namespace thenar::internal
