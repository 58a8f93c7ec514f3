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

/// Edges of one triangle only, by a vertex that stands for all they are connected with; each runs
/// as its triangle walks it.
std::map<int, std::vector<Edge>> open_edges(const TriangleMesh& mesh) {
  std::vector<Edge> open;
  for (const auto& [edge, uses] : edges_of(mesh)) {
    if (uses.up + uses.down == 1)
      open.push_back(uses.up == 1 ? edge : Edge(edge.second, edge.first));
  }
  std::vector<int> parent(static_cast<std::size_t>(mesh.vertices.cols()));
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [a, b] : open)
    parent[static_cast<std::size_t>(root(parent, a))] = root(parent, b);
  std::map<int, std::vector<Edge>> holes;
  for (const Edge& edge : open) holes[root(parent, edge.first)].push_back(edge);
  return holes;
}

Eigen::Vector3d centre_of(const TriangleMesh& mesh, const std::vector<Edge>& edges) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& [a, b] : edges) sum += (mesh.vertices.col(a) + mesh.vertices.col(b)) / 2;
  return sum / static_cast<double>(edges.size());
}

}  // namespace

MeshEdges check_edges(const TriangleMesh& mesh) {
  MeshEdges result;
  for (const auto& [edge, uses] : edges_of(mesh)) {
    const int count = uses.up + uses.down;
    if (count == 2 && uses.up != uses.down) ++result.flipped;
    if (count > 2) ++result.shared;
  }
  for (const auto& [vertex, edges] : open_edges(mesh))
    result.holes.push_back({static_cast<int>(edges.size()), centre_of(mesh, edges)});
  return result;
}

TriangleMesh close_holes(const TriangleMesh& mesh) {
  const std::map<int, std::vector<Edge>> holes = open_edges(mesh);
  Eigen::Index vertex = mesh.vertices.cols(), triangle = mesh.triangles.cols(), more = 0;
  for (const auto& [name, edges] : holes) more += static_cast<Eigen::Index>(edges.size());
  TriangleMesh closed = mesh;
  closed.vertices.conservativeResize(3, vertex + static_cast<Eigen::Index>(holes.size()));
  closed.triangles.conservativeResize(3, triangle + more);
  for (const auto& [name, edges] : holes) {
    closed.vertices.col(vertex) = centre_of(mesh, edges);
    for (const auto& [a, b] : edges)
      closed.triangles.col(triangle++) << b, a, static_cast<int>(vertex);
    ++vertex;
  }
  return closed;
}

}  // namespace thenar
