#pragma once

/// What shapes weigh.

#include <vector>

#include "geometry/mass_properties.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// Volume, centroid and inertia of a shape at density 1 kg/m^3, in the frame of its body. Of a
/// mesh, signed_moments() of its solid_parts(); nothing if it bounds no solid, as one with holes.
/// @throws InputError for a tapered capsule.
[[nodiscard]] MassProperties mass_at_unit_density(const ShapeSpec& shape);

/// Several rigidly together.
[[nodiscard]] MassProperties together(const std::vector<MassProperties>& parts);

// What the union of shapes weighs.

struct UnionMass {
  MassProperties mass;  // at unit density, in the frame of the body
  double error = 0;     // of the volume, relative: as it changed when cells were last halved, or by
                        // how much the sum of the parts may exceed it; 0: exact to rounding [1]
};

/// Volume, centre and inertia of the union of some shapes, of a mesh that of its solid_parts(), so
/// that nothing counts twice where they overlap.
///
/// Exact for what overlaps nothing and has a closed form (all but tapered capsules), and where all
/// that overlap are boxes and convex meshes, whose common parts are cut out (union_moments()). Else
/// what is counted too often, or the whole where there is no closed form, is summed over cubes of a
/// tree that is finest at the surfaces, 1/128 of its box: a cube without a surface counts fully,
/// the smallest are cut by the planes nearest to their middles. Work has a limit of a few seconds,
/// shared among groups of overlapping parts by their numbers: where that is too little, the sum of
/// the parts stands for their union, and `error` says by how much that may be smaller, since it
/// holds the largest part.
/// @throws InputError as build_solid()
[[nodiscard]] UnionMass union_mass(const std::vector<ShapeSpec>& shapes);

}  // namespace thenar
