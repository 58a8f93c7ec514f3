#pragma once

/// Repair of meshes that bound no solid.

#include <string>

#include "geometry/hull_mesh.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// A mesh that build_solid() accepts, with a list of its repairs.
struct RepairedSolid {
  TriangleMesh mesh;
  /// Repairs, like "2 holes closed, the longest 31.4 mm around"; empty if there were none.
  std::string done;
};

/// Repairs a surface from files of robots and visual models, by the following steps until
/// solid_parts() accepts it: corners closer than 1e-6 (1e-5, 1e-4 if that leaves fewer open edges)
/// of its extent are merged; triangles are cut where corners of others are on their edges;
/// triangles of zero area and duplicates are removed, and both of a pair that face each other; all
/// are oriented consistently; holes are closed by fans; parts that enclose nothing are left out.
/// Parts that are still no solid, and the whole if most of its area would be left out, are replaced
/// by their convex hulls.
/// @throws InputError if the mesh is flat, even the convex hull of the whole is, or a corner is no
/// vertex or not finite.
[[nodiscard]] RepairedSolid repair_to_solid(const TriangleMesh& mesh);

/// Repairs a surface by repair_to_solid(), and also what build_solid() tolerates: triangles that
/// face inwards are reversed, those of zero area and duplicates removed, so that check_mesh() finds
/// no defect and a volume above 0.
/// @throws InputError as repair_to_solid().
[[nodiscard]] RepairedSolid watertight_mesh(const TriangleMesh& mesh);

}  // namespace thenar
