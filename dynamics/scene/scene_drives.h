#pragma once

/// Adds forces, drives and stepping options of a scene file to a built scene.

#include "data/io/scene/scene.h"
#include "dynamics/scene/build_scene.h"

namespace thenar {

/// Adds the forces on bodies, by default at their centres of mass.
/// @param built  scene with a complete mechanism
/// @throws DataError at the line of a force whose body does not exist.
void add_forces(const SceneSpec& spec, BuiltScene& built);

/// Adds the drives of coordinates, with their target tables.
/// @param built  scene with a complete mechanism
/// @throws DataError at the line of a drive whose coordinate does not exist or has other units.
void add_drives(const SceneSpec& spec, BuiltScene& built);

/// Sets stepping method, step lengths and contact compliance; values that the file does not state
/// keep their defaults.
/// @throws DataError at the line of an unknown method or friction ramp.
void set_stepping(const SceneSpec& spec, BuiltScene& built);

}  // namespace thenar
