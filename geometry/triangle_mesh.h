#pragma once

/// Triangle meshes and their edges.

#include <vector>

#include "base/spatial.h"

namespace thenar {

/// A surface of triangles, whose corners are counterclockwise seen from outside.
struct TriangleMesh {
  Eigen::Matrix3Xd vertices;   // [m] (3, vertices)
  Eigen::Matrix3Xi triangles;  // columns of `vertices` (3, triangles)

  [[nodiscard]] bool empty() const { return triangles.cols() == 0; }
};

/// Returns the area of all triangles [m^2].
[[nodiscard]] double area_of(const TriangleMesh& mesh);

/// Returns the extents of points along the axes of inertia of equal masses there [m] (3).
[[nodiscard]] Eigen::Vector3d principal_extents(const Eigen::Matrix3Xd& points);

/// Moves a mesh, or changes its frame.
void move_by(TriangleMesh& mesh, const Pose<double>& X);

// Edges of a mesh and the triangles that meet there.

/// A side of a triangle, listed at the edge between two vertices.
struct MeshSide {
  int low = 0, high = 0;  // vertices of the edge, the smaller number first
  int triangle = 0;       // entry of the mesh
  int side = 0;           // starts at corner `side` of the triangle
  bool upwards = false;   // whether the triangle traverses it from the smaller vertex to the larger
};

/// Returns all sides, sorted by edge (low, high) and at each edge by triangle and side, in linear
/// time.
/// @param mesh  mesh whose corners are valid vertices
[[nodiscard]] std::vector<MeshSide> sides_by_edge(const TriangleMesh& mesh);

/// Calls visit(first, last) with the range of sides at each edge, as pointers.
template <typename Visit>
void for_each_edge(const std::vector<MeshSide>& sides, const Visit& visit) {
  const MeshSide* const end = sides.data() + sides.size();
  for (const MeshSide* first = sides.data(); first != end;) {
    const MeshSide* last = first + 1;
    while (last != end && last->low == first->low && last->high == first->high) ++last;
    visit(first, last);
    first = last;
  }
}

/// Returns the triangle across each side where exactly two meet, elsewhere -1 (3, triangles).
[[nodiscard]] Eigen::Matrix3Xi neighbours_across(const TriangleMesh& mesh);

}  // namespace thenar
