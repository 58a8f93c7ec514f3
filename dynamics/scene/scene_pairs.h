#pragma once

/// Pairs of bodies of a scene that may touch, and their friction.

#include "data/io/scene/scene.h"
#include "dynamics/scene/build_scene.h"

namespace thenar {

/// Sets the pairs that are apart and the friction of all others, as build_scene() says; warns of
/// bodies that begin in each other.
/// @throws DataError at the line of the file that names what is not there, or names a pair twice,
/// or if two materials have no friction.
void set_pairs(const SceneSpec& spec, BuiltScene& built);

/// Coefficient of friction of two bodies, by the same rule, also where they are apart [1].
/// @throws DataError as set_pairs().
[[nodiscard]] double friction_between(const SceneSpec& spec, const BuiltScene& built, int a, int b);

}  // namespace thenar
