#pragma once

/// Meshes of projections and slices of wrench sets in three coordinates.

#include <array>

#include "base/enum_names.h"
#include "geometry/triangle_mesh.h"
#include "grasp/limits/wrench_support.h"

namespace thenar {

/// Reduction of six dimensions to three.
enum class PictureKind {
  kProjection,  // three coordinates of all wrenches
  kSlice  // three coordinates of wrenches whose others are zero, such as forces without torque
};
inline constexpr std::array kPictureKindNames{EnumName{PictureKind::kProjection, "projection"},
                                              EnumName{PictureKind::kSlice, "slice"}};

/// Boundary mesh of a projection or slice.
struct [[nodiscard]] WrenchSetMesh {
  TriangleMesh mesh;  // vertices on the boundary of the set, in the requested axes [N]
  int failed = 0;  // number of directions without an answer, with a vertex at the origin: the set
                   // is unbounded there, or does not contain the origin
};

/// Computes the boundary of a projection or slice as seen from the origin: support_along() in each
/// direction of a subdivided octahedron. Triangles between boundary points of a convex set lie
/// within it. Flat sets give flat meshes.
/// @param coordinates  three different coordinates of the wrench: 0..2 forces, 3..5 torques
/// @param pieces       subdivisions of each edge of the octahedron, for 4 pieces^2 + 2 directions
/// @throws InputError if coordinates repeat or are not 0..5, or pieces < 1
WrenchSetMesh wrench_set_mesh(const ForceSet& forces, const std::array<int, 3>& coordinates,
                              PictureKind kind, int pieces = 8);

}  // namespace thenar
