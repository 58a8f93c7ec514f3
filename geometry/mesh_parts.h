#pragma once

/// A mesh as the closed surfaces it is made of.

#include <vector>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// All triangles of some meshes as one mesh.
[[nodiscard]] TriangleMesh joined(const std::vector<TriangleMesh>& parts);

/// Triangles that hang together over edges of exactly two, each part with vertices of its own.
[[nodiscard]] std::vector<TriangleMesh> connected_parts(const TriangleMesh& mesh);

/// The solids whose union a mesh bounds. Triangles that face inwards are turned, those of no area
/// or there twice are dropped. A surface that faces inwards within another is a cavity and stays
/// with it; elsewhere it is turned outwards. Parts may overlap.
/// @throws InputError if the mesh has no triangle, has holes (naming them), an edge of a part has
/// more than two triangles, or a part encloses nothing.
[[nodiscard]] std::vector<TriangleMesh> solid_parts(const TriangleMesh& mesh);

}  // namespace thenar
