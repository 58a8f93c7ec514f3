#pragma once

/// Where a surface is open, and closing it.

#include <vector>

#include "base/shapes/triangle_mesh.h"

namespace thenar {

/// Edges with one triangle only, connected.
struct MeshHole {
  int edges = 0;
  Eigen::Vector3d centre{0, 0, 0};  // mean of the middles of its edges [m] (3)
};

struct MeshEdges {
  std::vector<MeshHole> holes;
  int shared = 0;   // edges of three or more triangles
  int flipped = 0;  // edges that two triangles walk the same way
  [[nodiscard]] bool watertight() const { return holes.empty() && shared == 0 && flipped == 0; }
};

[[nodiscard]] MeshEdges check_edges(const TriangleMesh& mesh);

/// The surface with every hole closed by triangles from its edges to its centre.
[[nodiscard]] TriangleMesh close_holes(const TriangleMesh& mesh);

}  // namespace thenar
