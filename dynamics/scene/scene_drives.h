#pragma once

/// What acts on a scene from outside, and how it is stepped, as its file says.

#include "data/io/scene/scene.h"
#include "dynamics/scene/build_scene.h"

namespace thenar {

/// Adds the forces on bodies, by default at their centres of mass.
/// @param built  its mechanism is complete
/// @throws DataError at the line of a force whose body is not there.
void add_forces(const SceneSpec& spec, BuiltScene& built);

/// Adds the drives of coordinates, with their tables of targets.
/// @param built  its mechanism is complete
/// @throws DataError at the line of a drive whose coordinate is not there or has another unit.
void add_drives(const SceneSpec& spec, BuiltScene& built);

/// Sets method, steps and compliance of contacts; the defaults where the file states none.
/// @throws DataError at the line of the file that names no method or ramp of friction.
void set_stepping(const SceneSpec& spec, BuiltScene& built);

}  // namespace thenar
