#pragma once

/// Triangle meshes and their edges.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// A surface of triangles, whose corners stand counterclockwise seen from outside.
struct TriangleMesh {
  Eigen::Matrix3Xd vertices;   // [m] (3, vertices)
  Eigen::Matrix3Xi triangles;  // columns of `vertices` (3, triangles)

  [[nodiscard]] bool empty() const { return triangles.cols() == 0; }
};

// Edges of a mesh and the triangles that meet there.

/// A side of a triangle, as one of those at the edge between two vertices.
struct MeshSide {
  int low, high;  // vertices of the edge, the lesser first
  int triangle;   // of the mesh
  int side;       // from corner `side` of the triangle to the next
  bool upwards;   // the triangle walks from the lesser vertex to the greater
};

/// Returns all sides, ordered by edge (low, high) and at each edge by triangle and side, in a time
/// that grows with their number.
/// @param mesh  whose corners are vertices
[[nodiscard]] std::vector<MeshSide> sides_by_edge(const TriangleMesh& mesh);

/// Calls visit(first, last) with the sides at each edge, as pointers.
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

/// The triangle across each side where exactly two meet, elsewhere -1 (3, triangles).
[[nodiscard]] Eigen::Matrix3Xi neighbours_across(const TriangleMesh& mesh);

}  // namespace thenar
