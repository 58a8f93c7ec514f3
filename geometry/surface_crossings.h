#pragma once

/// Places where a surface intersects itself or overlaps itself.

#include <vector>

#include "geometry/triangle_mesh.h"
#include "geometry/triangle_tree.h"

namespace thenar::internal {

/// Finds the triangles of a closed surface that meet others elsewhere than at common corners and
/// edges, and neighbours that are folded onto each other. Triangles closer than 1e-10 of the mesh's
/// extent count as meeting. If there are none, the surface is embedded, and its nearest feature
/// determines what is inside. If boxes of triangles overlap in more than 100 pairs per triangle, as
/// in fans of thousands, all count as meeting.
/// @param tree  tree of the mesh
/// @returns whether each triangle of the mesh meets another
[[nodiscard]] std::vector<bool> crossing_triangles(const TriangleMesh& mesh,
                                                   const TriangleTree& tree);

}  // namespace thenar::internal
