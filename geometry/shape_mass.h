#pragma once

/// Mass properties of shapes.

#include <vector>

#include "geometry/mass_properties.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// Computes volume, centroid and inertia of a shape at density 1 kg/m^3, in the frame of its body.
/// For a mesh it sums signed_moments() of its solid_parts(); zero if it bounds no solid, for
/// example with holes.
[[nodiscard]] MassProperties mass_at_unit_density(const ShapeSpec& shape);

/// Sums the mass properties of several bodies fixed to each other.
[[nodiscard]] MassProperties sum_of_masses(const std::vector<MassProperties>& parts);

// Mass properties of the union of shapes.

/// Mass properties of a union, with their error.
struct UnionMass {
  MassProperties mass;  // at unit density, in the frame of the body
  double error = 0;     // relative error of the volume: its change in the last halving of cells, or
                        // the excess of the sum of the parts; 0: exact to rounding [1]
};

/// Computes volume, centre and inertia of the union of shapes, where a mesh is the union of its
/// solid_parts(), so that overlaps are counted once.
///
/// Exact for shapes without overlaps, and if all overlapping shapes are boxes and convex meshes,
/// whose common parts are subtracted (union_moments()). Otherwise the part that is counted too
/// often, or the whole if that is less, is summed over cubes of a tree that is finest at the
/// surfaces, 1/128 of its box: a cube without a surface counts fully, the smallest are cut by the
/// planes nearest to their centres. Work is limited to about a second, shared among groups of
/// overlapping parts by their numbers: if that is not enough, cubes stay coarser, and `error` is
/// the change of the last halving. If not even cubes of 1/16 can be summed, the sum of the parts
/// replaces their union, and `error` is its maximum excess, since the union contains the largest
/// part.
/// @throws InputError as build_solid()
[[nodiscard]] UnionMass union_mass(const std::vector<ShapeSpec>& shapes);

}  // namespace thenar
