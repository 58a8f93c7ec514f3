#pragma once

/// Signed distance to a triangle mesh.

#include <memory>

#include "geometry/shape.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Builds the signed distance, exact to rounding. The sign is that of (p - foot) . n, where n is
/// the sum of the normals of an edge's two faces, or of those around a corner, each weighted with
/// its angle there: this is correct everywhere, inside cavities as well [Baerentzen2005].
///
/// Up to one length of the mesh around it, cubes list the triangles that may be nearest; farther
/// away, and where lists would be long, a tree of boxes is searched from a first guess.
///
/// Lists are filled on demand, with results that do not depend on earlier queries or the number of
/// threads. Meshes of the same content share them within a process.
///
/// @param mesh  watertight, outward, without triangles of zero area, as from build_solid()
[[nodiscard]] std::shared_ptr<const Shape> build_mesh_distance(const TriangleMesh& mesh);

/// Returns whether a shape is from build_mesh_distance(), and its surface intersects itself.
[[nodiscard]] bool goes_through_itself(const Shape& shape);

}  // namespace thenar
