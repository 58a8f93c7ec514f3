#pragma once

/// What a body weighs.

#include "data/io/world/world.h"

namespace thenar {

/// The mass of a body: as stated, or spread evenly over the union of its shapes by its mass, its
/// density or its material's, the first of these that is known.
///
/// Where shapes overlap nothing counts twice; union_mass() says where that is exact.
/// @throws InputError if neither mass nor density is known, with the keys that state them, or the
///         shapes enclose nothing.
[[nodiscard]] BodyMass body_mass(const BodySpec& body,
                                 const Materials& materials = built_in_materials());

}  // namespace thenar
