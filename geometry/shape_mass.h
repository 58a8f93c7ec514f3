#pragma once

/// Mass properties of shapes.

#include <vector>

#include "geometry/mass_properties.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// Volume, centroid and inertia of a shape at density 1 kg/m^3, in the frame of its body. For a
/// mesh, signed_moments() of its solid_parts(); zero if it bounds no solid, for example with holes.
/// @throws InputError for a tapered capsule.
[[nodiscard]] MassProperties mass_at_unit_density(const ShapeSpec& shape);

/// Mass properties of several bodies fixed to each other.
[[nodiscard]] MassProperties together(const std::vector<MassProperties>& parts);

// Mass properties of the union of shapes.

struct UnionMass {
  MassProperties mass;  // at unit density, in the frame of the body
  double error = 0;     // of the volume, relative: as it changed when cells were last halved, or by
                        // how much the sum of the parts may exceed it; 0: exact to rounding [1]
};

/// Volume, centre and inertia of the union of shapes, where a mesh is the union of its
/// solid_parts(), so that nothing counts twice where they overlap.
///
/// Exact for shapes that overlap nothing and have a closed form (all except tapered capsules), and
/// where all overlapping shapes are boxes and convex meshes, whose common parts are cut out
/// (union_moments()). Otherwise the part that is counted too often, or the whole where there is no
/// closed form, is summed over cubes of a tree that is finest at the surfaces, 1/128 of its box: a
/// cube without a surface counts fully, the smallest are cut by the planes nearest to their
/// middles. Work is limited to about a second, shared among groups of overlapping parts by their
/// numbers: where that is too little, cubes stay coarser, and `error` says how much the last
/// halving changed. Where not even cubes of 1/16 can be summed, the sum of the parts stands for
/// their union, and `error` says by how much that may be smaller, since the union holds the largest
/// part.
/// @throws InputError as build_solid()
[[nodiscard]] UnionMass union_mass(const std::vector<ShapeSpec>& shapes);

}  // namespace thenar
