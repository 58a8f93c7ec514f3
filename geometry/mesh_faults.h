#pragma once

/// Causes that prevent a surface from bounding a solid, besides the open edges that they leave.

#include <string>
#include <vector>

#include "geometry/shape_spec.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Returns whether all triangles are in one plane, or on a line: the thickness is at most 1e-6 of
/// their extent, the rounding of files in single precision.
[[nodiscard]] bool is_flat(const TriangleMesh& mesh);

/// Returns whether one of the shapes is a flat mesh.
[[nodiscard]] bool any_is_flat(const std::vector<ShapeSpec>& shapes);

/// Faults of a mesh in which check_mesh() finds holes. Without holes only `flat` and edges are set.
struct MeshFaults {
  bool flat = false;  // is_flat(): it cannot be repaired to a solid; nothing else is counted then
  int holes = 0;      // holes of parts that would enclose something if they were closed
  int seams = 0;      // holes of no width: corners of triangles on edges of others
  int flaps = 0;  // triangles of flat parts that are connected to the surface by at most an edge:
                  // fins, sheets
  int degenerate = 0;         // triangles without area
  int nonmanifold_edges = 0;  // edges of more than two triangles that have an area
};

/// Finds causes part by part, without triangles of zero area and duplicates. Flat parts count as
/// flaps if another part is not flat.
/// @throws InputError as check_mesh().
[[nodiscard]] MeshFaults find_mesh_faults(const TriangleMesh& mesh);

/// Describes the causes, like "it is flat: .." or "1 triangle(s) of fins or sheets that enclose
/// nothing"; "" if there are none, or only holes.
[[nodiscard]] std::string describe(const MeshFaults& faults);

}  // namespace thenar
