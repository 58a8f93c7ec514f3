#pragma once

/// Meshes of wrench sets, projected to or cut by three coordinates.

#include <array>

#include "base/enum_names.h"
#include "geometry/triangle_mesh.h"
#include "grasp/limits/wrench_support.h"

namespace thenar {

/// Projection of six dimensions to three.
enum class PictureKind {
  kProjection,  // three coordinates of all wrenches
  kSlice        // three coordinates of wrenches whose others are zero: forces without torque
};
inline constexpr std::array kPictureKindNames{EnumName{PictureKind::kProjection, "projection"},
                                              EnumName{PictureKind::kSlice, "slice"}};

/// Boundary mesh of a projection or slice.
struct [[nodiscard]] WrenchSetMesh {
  TriangleMesh mesh;  // vertices on the boundary of the set, in the axes asked for [N]
  int failed = 0;     // directions without an answer, drawn at the origin: the set is unbounded
                      // there, or does not contain the origin
};

/// Boundary of a projection or slice, seen from the origin: support_along() in each direction of a
/// subdivided octahedron. Triangles between boundary points of a convex set lie within it. Flat
/// sets give flat meshes.
/// @param coordinates  three different ones of the wrench: 0..2 forces, 3..5 torques
/// @param pieces       of each edge of the octahedron; there are 4 pieces^2 + 2 directions
/// @throws InputError if coordinates repeat or are not 0..5, or pieces < 1
WrenchSetMesh wrench_set_mesh(const ForceSet& forces, const std::array<int, 3>& coordinates,
                              PictureKind kind, int pieces = 8);

}  // namespace thenar
