#pragma once

/// Causes that keep a surface from bounding a solid, beside the open edges that they leave.

#include <string>
#include <vector>

#include "geometry/shape_spec.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Returns whether all triangles lie in one plane, or on a line: no thickness beyond a millionth of
/// their extent, as files in single precision round.
[[nodiscard]] bool is_flat(const TriangleMesh& mesh);

/// Returns whether one of the shapes is a flat mesh.
[[nodiscard]] bool any_is_flat(const std::vector<ShapeSpec>& shapes);

/// Faults of a mesh in which check_mesh() finds holes. Without holes only `flat` and edges count.
struct MeshFaults {
  bool flat = false;   // is_flat(): no repair makes a solid of it; nothing else is counted then
  int holes = 0;       // of parts that would enclose something if they were closed
  int seams = 0;       // holes of no width: corners of triangles lie on edges of others
  int flaps = 0;       // triangles of flat parts that hang on the surface by an edge at most: fins,
                       // sheets
  int degenerate = 0;  // triangles of no area
  int nonmanifold_edges = 0;  // of more than two triangles that have an area
};

/// Looks for causes part by part, without triangles of no area or there twice. Parts that are flat
/// by themselves count as flaps where another part is not.
/// @throws InputError as check_mesh().
[[nodiscard]] MeshFaults find_mesh_faults(const TriangleMesh& mesh);

/// "it is flat: .." or "1 triangle(s) of fins or sheets that enclose nothing", the causes in words;
/// "" where there are none but holes, or none at all.
[[nodiscard]] std::string describe(const MeshFaults& faults);

}  // namespace thenar
