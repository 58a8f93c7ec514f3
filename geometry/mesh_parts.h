#pragma once

/// Decomposition of a mesh into the closed surfaces it is made of.

#include <vector>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// Joins all triangles of some meshes into one mesh.
[[nodiscard]] TriangleMesh joined(const std::vector<TriangleMesh>& parts);

/// Splits a mesh into parts connected over edges of exactly two triangles, each with own vertices.
[[nodiscard]] std::vector<TriangleMesh> connected_parts(const TriangleMesh& mesh);

/// The solids whose union a mesh bounds. Triangles that face inwards are turned, those of no area
/// or there twice are dropped. A surface that faces inwards within another is a cavity and stays
/// with it; elsewhere it is turned outwards. Parts may overlap.
/// @throws InputError if the mesh has no triangle, has holes (naming them), an edge of a part has
/// more than two triangles, or a part encloses nothing.
[[nodiscard]] std::vector<TriangleMesh> solid_parts(const TriangleMesh& mesh);

}  // namespace thenar
