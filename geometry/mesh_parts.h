#pragma once

/// Decomposition of a mesh into the closed surfaces it is made of.

#include <string>
#include <vector>

#include "geometry/mesh_check.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Joins all triangles of some meshes into one mesh.
[[nodiscard]] TriangleMesh joined(const std::vector<TriangleMesh>& parts);

/// Splits a mesh into parts connected over edges of exactly two triangles, each with own vertices.
[[nodiscard]] std::vector<TriangleMesh> connected_parts(const TriangleMesh& mesh);

/// Diagonal of the box around the vertices of a mesh [m].
[[nodiscard]] double diagonal_of(const TriangleMesh& mesh);

/// Returns whether a closed surface encloses next to nothing: flat, thinner than 3e-5 of its
/// length, or smaller than 5e-5 of what it is part of.
/// @param volume  [m^3]
/// @param own, whole  diagonals of the surface and of what it is part of [m]
[[nodiscard]] bool is_sliver(double volume, double own, double whole);

/// Describes why a mesh with holes bounds no solid: causes of describe(MeshFaults), and the holes
/// if they are not left by these.
/// @param found  check_mesh() of it
[[nodiscard]] std::string why_open(const TriangleMesh& mesh, const MeshReport& found);

/// The solids whose union a mesh bounds. Triangles that face inwards are turned, those of no area
/// or there twice are dropped. A surface that faces inwards within another is a cavity and stays
/// with it; elsewhere it is turned outwards. Slivers are left out. Parts may overlap.
/// @throws InputError if the mesh has no triangle, is flat, has holes (naming their cause), an edge
/// of a part has more than two triangles, or a part encloses nothing.
[[nodiscard]] std::vector<TriangleMesh> solid_parts(const TriangleMesh& mesh);
/// Returns solid_parts(); none where it would refuse the mesh.
[[nodiscard]] std::vector<TriangleMesh> solids_or_none(const TriangleMesh& mesh);

}  // namespace thenar
