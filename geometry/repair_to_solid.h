#pragma once

/// Repair of meshes that bound no solid, so that they do.

#include <string>

#include "geometry/hull_mesh.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// A mesh that build_solid() accepts, and the repairs that were made.
struct RepairedSolid {
  TriangleMesh mesh;
  std::string done;  // "2 holes closed, the longest 31.4 mm around"; empty if nothing was done
};

/// Repairs a surface as files of robots and visual models hold it, in this order until
/// solid_parts() accepts it: corners closer than 1e-6 (1e-5, 1e-4 if that leaves fewer open edges)
/// of its extent become one; triangles are cut where corners of others lie on their edges;
/// triangles of no area and duplicates are dropped, pairs that face each other both; all are turned
/// to agree; holes are closed by fans; parts that enclose nothing are left out. Parts that are
/// still no solid, and the whole if most of its area would be left out, are replaced by their
/// convex hulls.
/// @throws InputError if the mesh is flat, even the convex hull of the whole is, or a corner is no
/// vertex or not finite.
[[nodiscard]] RepairedSolid repair_to_solid(const TriangleMesh& mesh);

/// repair_to_solid(), and the repair of what build_solid() tolerates: triangles that face inwards
/// are turned, those of no area and duplicates dropped, so that check_mesh() finds nothing and a
/// volume above 0.
/// @throws InputError as repair_to_solid().
[[nodiscard]] RepairedSolid watertight_mesh(const TriangleMesh& mesh);

}  // namespace thenar
