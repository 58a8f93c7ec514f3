#include "apps/mesh_holes.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace thenar {
namespace {

/// How often triangles walk an edge from its lower vertex up, and down.
struct Uses {
  int up = 0, down = 0;
};

using Edge = std::pair<int, int>;

std::map<Edge, Uses> edges_of(const TriangleMesh& mesh) {
  std::map<Edge, Uses> edges;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles(k, i), b = mesh.triangles((k + 1) % 3, i);
      Uses& uses = edges[std::minmax(a, b)];
      ++(a < b ? uses.up : uses.down);
    }
  return edges;
}

/// The representative of a vertex among those joined so far.
int root(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    int& above = parent[static_cast<std::size_t>(i)];
    above = parent[static_cast<std::size_t>(above)];
    i = above;
  }
  return i;
}

std::vector<MeshHole> holes_of(const TriangleMesh& mesh, const std::vector<Edge>& open) {
  std::vector<int> parent(static_cast<std::size_t>(mesh.vertices.cols()));
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [a, b] : open)
    parent[static_cast<std::size_t>(root(parent, a))] = root(parent, b);
  std::map<int, MeshHole> holes;
  for (const auto& [a, b] : open) {
    MeshHole& hole = holes[root(parent, a)];
    ++hole.edges;
    hole.centre += (mesh.vertices.col(a) + mesh.vertices.col(b)) / 2;
  }
  std::vector<MeshHole> list;
  for (auto& [vertex, hole] : holes) {
    hole.centre /= hole.edges;
    list.push_back(hole);
  }
  return list;
}

}  // namespace

MeshEdges check_edges(const TriangleMesh& mesh) {
  MeshEdges result;
  std::vector<Edge> open;
  for (const auto& [edge, uses] : edges_of(mesh)) {
    const int count = uses.up + uses.down;
    if (count == 1) open.push_back(edge);
    if (count == 2 && uses.up != uses.down) ++result.flipped;
    if (count > 2) ++result.shared;
  }
  result.holes = holes_of(mesh, open);
  return result;
}

}  // namespace thenar
