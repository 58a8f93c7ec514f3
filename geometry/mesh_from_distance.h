#pragma once

/// Triangulation of the surface of any solid.

#include "geometry/shape.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Triangles of about the cell's size with their corners on the surface, counterclockwise seen from
/// outside. Always watertight: every edge belongs to two triangles that walk it in opposite ways,
/// and the triangles around a corner form one ring.
///
/// Dual to marching cubes: each patch of the surface in a cell of a cubic grid becomes a vertex,
/// each edge of the grid that leaves the solid a quadrilateral; where two corners of a face across
/// from each other are inside they are held apart. Parts thinner than a cell may be lost, sharp
/// edges are cut off by up to a cell. Source: [Nielson2004].
///
/// @param solid  asked near its surface only, as far as its distance may be trusted
/// @param cell   edge of the grid's cells > 0 [m]
/// @throws InputError if the cell is not positive and finite, or the grid has more than 1e8 nodes.
[[nodiscard]] TriangleMesh mesh_from_distance(const Shape& solid, double cell);

}  // namespace thenar
