#pragma once

/// Meshes that bound no solid, made to.

#include <string>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// A mesh that build_solid() takes, and what was done to it.
struct RepairedSolid {
  TriangleMesh mesh;
  std::string done;  // "2 holes closed, the longest 31.4 mm around"; empty: nothing
};

/// A surface as files of robots and visual models hold it, mended in this order until
/// solid_parts() takes it: corners closer than 1e-6 (1e-5, 1e-4 if that leaves fewer open edges) of
/// its extent become one; triangles with a corner of others on their edge are cut there; triangles
/// of no area or there twice are dropped, pairs that face each other both; all are turned to agree;
/// holes are closed by fans; parts that enclose nothing are left out. Parts that are still no
/// solid, and the whole if most of its area would be left out, give way to their convex hulls.
/// @throws InputError if even the convex hull of the whole is flat, or a corner is no vertex or not
/// finite.
[[nodiscard]] RepairedSolid repair_to_solid(const TriangleMesh& mesh);

/// repair_to_solid(), and what build_solid() forgives put right as well: triangles that face
/// inwards are turned, those of no area or there twice dropped, so that check_mesh() finds nothing
/// and a volume above 0.
/// @throws InputError as repair_to_solid().
[[nodiscard]] RepairedSolid watertight_mesh(const TriangleMesh& mesh);

// The convex hull of points as a mesh.

/// Watertight, outward, to a millionth of the points' extent: each point is moved by up to half of
/// that, always the same way, so that no four lie in a plane. Where the hull's least thickness is
/// below 1e-4 of its extent it is empty.
/// @param points  (3, n) [m]
/// @throws InputError if a coordinate is not finite.
[[nodiscard]] TriangleMesh hull_mesh(const Eigen::Matrix3Xd& points);

}  // namespace thenar
