#pragma once

/// Decomposition of a mesh into the closed surfaces of which it consists.

#include <string>
#include <vector>

#include "geometry/mesh_check.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Joins all triangles of several meshes in one mesh.
[[nodiscard]] TriangleMesh joined(const std::vector<TriangleMesh>& parts);

/// Splits a mesh into parts connected over edges of exactly two triangles, each with its own
/// vertices.
[[nodiscard]] std::vector<TriangleMesh> connected_parts(const TriangleMesh& mesh);

/// Returns the diagonal of the bounding box of a mesh [m].
[[nodiscard]] double diagonal_of(const TriangleMesh& mesh);

/// Returns whether a closed surface encloses almost nothing: it is flat, thinner than 3e-5 of its
/// length, or smaller than 5e-5 of the whole.
/// @param volume      [m^3]
/// @param own, whole  diagonals of the surface and of the whole to which it belongs [m]
[[nodiscard]] bool is_sliver(double volume, double own, double whole);

/// Explains why a mesh with holes bounds no solid: the causes of describe(MeshFaults), and the
/// holes unless these causes leave them.
/// @param found  check_mesh() of it
[[nodiscard]] std::string explain_open_mesh(const TriangleMesh& mesh, const MeshReport& found);

/// Returns the solids whose union a mesh bounds. Triangles that face inwards are reversed, those of
/// zero area and duplicates are removed. A surface that faces inwards within another is a cavity
/// and stays with it; elsewhere it is reversed. Slivers are left out. Parts may overlap.
/// @throws InputError if the mesh has no triangle, is flat, has holes (the message names their
/// cause), an edge
/// of a part has more than two triangles, or a part encloses nothing.
[[nodiscard]] std::vector<TriangleMesh> solid_parts(const TriangleMesh& mesh);
/// Returns solid_parts(); none if it would reject the mesh.
[[nodiscard]] std::vector<TriangleMesh> solids_or_none(const TriangleMesh& mesh);

}  // namespace thenar
