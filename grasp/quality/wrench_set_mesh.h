#pragma once

/// Three-dimensional pictures of wrench sets.

#include <array>

#include "geometry/triangle_mesh.h"
#include "grasp/limits/wrench_support.h"

namespace thenar {

enum class PictureKind {
  kProjection,  // the three coordinates of all wrenches
  kSlice        // those of wrenches whose other three coordinates are zero: forces without torque
};

struct [[nodiscard]] WrenchSetMesh {
  TriangleMesh mesh;  // vertices on the boundary of the set, in newtons, axes as asked
  int failed = 0;     // directions without an answer, drawn at the origin: the set is unbounded
                      // there, or does not hold the origin
};

/// Boundary of a projection or slice, seen from the origin: along each of the directions of a
/// subdivided octahedron as far as support_along() goes. Triangles between points on the
/// boundary of a convex set lie within it. Flat sets give flat meshes.
/// @param coordinates  three different ones of the wrench: 0..2 forces, 3..5 torques
/// @param pieces       of each edge of the octahedron; 4 pieces^2 + 2 directions
/// @throws InputError if coordinates repeat or are not 0..5, or pieces < 1
WrenchSetMesh wrench_set_mesh(const ForceSet& forces, const std::array<int, 3>& coordinates,
                              PictureKind kind, int pieces = 8);

}  // namespace thenar
