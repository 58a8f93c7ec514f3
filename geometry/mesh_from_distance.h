#pragma once

/// Triangulation of the surface of any solid.

#include "geometry/shape.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Builds triangles of about the cell's size with their corners on the surface, counterclockwise
/// seen from outside. The mesh is always watertight: every edge belongs to two triangles that
/// traverse it in opposite directions, and the triangles around a corner form one ring.
///
/// Dual marching cubes: each patch of the surface in a cell of a cubic grid becomes a vertex, each
/// edge of the grid that leaves the solid a quadrilateral; where two diagonally opposite corners of
/// a face are inside they are kept apart. Parts thinner than a cell may be lost, sharp edges are
/// cut off by up to a cell. Source: [Nielson2004].
///
/// @param solid  evaluated only near its surface, so that its distance need be valid only there
/// @param cell   edge of the grid's cells > 0 [m]
/// @throws InputError if the cell is not positive and finite, or the grid has more than 1e8 nodes.
[[nodiscard]] TriangleMesh mesh_from_distance(const Shape& solid, double cell);

}  // namespace thenar
