#pragma once

/// Signed distance to a triangle mesh.

#include <memory>

#include "geometry/shape.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Builds the signed distance, exact to rounding. The sign is that of (p - foot) . n, where n is
/// the sum of those of an edge's two faces, or the sum of those around a corner, each weighted with
/// its angle there: right everywhere, inside cavities as well [Baerentzen2005].
///
/// Up to one length of the mesh around it, cubes list the triangles that may be nearest; farther
/// away, and where those would be many, a tree of boxes is searched from a first guess.
///
/// Lists are filled as they are asked for, with the same answers whatever was asked before and from
/// however many threads. Meshes of the same content share them within a process.
///
/// @param mesh  watertight, outward, no triangle of no area: what build_solid() makes of meshes
[[nodiscard]] std::shared_ptr<const Shape> build_mesh_distance(const TriangleMesh& mesh);

/// Returns whether a shape is of build_mesh_distance(), and its surface goes through itself.
[[nodiscard]] bool goes_through_itself(const Shape& shape);

}  // namespace thenar
