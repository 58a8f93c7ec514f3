#pragma once

/// Places where a surface goes through itself or lies on itself.

#include <vector>

#include "geometry/triangle_mesh.h"
#include "geometry/triangle_tree.h"

namespace thenar::internal {

/// Finds the triangles of a closed surface that meet others elsewhere than at common corners and
/// edges, and neighbours that are folded onto each other. Triangles closer than 1e-10 of the
/// mesh's extent count as meeting. If there is none, the surface is embedded, and the side of its
/// nearest feature decides what is inside. Where boxes of triangles meet in more than 100 pairs a
/// triangle, as in fans of thousands, all count as meeting.
/// @param tree  of the mesh
/// @returns whether each triangle of the mesh meets another
[[nodiscard]] std::vector<bool> crossing_triangles(const TriangleMesh& mesh,
                                                   const TriangleTree& tree);

}  // namespace thenar::internal
