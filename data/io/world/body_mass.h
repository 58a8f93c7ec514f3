#pragma once

/// What a body weighs.

#include "data/io/world/world.h"

namespace thenar {

/// The mass of a body: as stated, or spread evenly over the union of its shapes by its mass, its
/// density or its material's, the first of these that is known.
///
/// Exact for one sphere, box, cylinder, capsule, ellipsoid or mesh of one surface. Other bodies are
/// summed up over cells of 1/96 of their longest side, partly filled ones by their signed distance
/// d as 1/2 - d / cell: to about 0.5 % in mass.
/// @throws InputError if neither mass nor density is known, with the keys that state them, or the
///         shapes enclose nothing.
[[nodiscard]] BodyMass body_mass(const BodySpec& body,
                                 const Materials& materials = built_in_materials());

}  // namespace thenar
