#pragma once

/// Sets the contact pairs of a scene and their friction.

#include "data/io/scene/scene.h"
#include "dynamics/scene/build_scene.h"

namespace thenar {

/// Sets the pairs without contacts and the friction of all others, see build_scene(). Warns of
/// bodies that overlap at the start.
/// @throws DataError at the line of the file with an unknown body or a pair that is named twice, or
/// if the friction of two materials is not known.
void set_pairs(const SceneSpec& spec, BuiltScene& built);

/// Returns the coefficient of friction of two bodies by the rules of build_scene(), also for pairs
/// without contacts [1].
/// @throws DataError as set_pairs().
[[nodiscard]] double friction_between(const SceneSpec& spec, const BuiltScene& built, int a, int b);

}  // namespace thenar
