#include "live/world/nail_mesh.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace thenar {
namespace {

constexpr double kCornerTolerance = 1e-8;  // distance below which two corners are merged [m]

/// Mesh under construction.
struct GrowingMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3i> triangles;

  int add(const Eigen::Vector3d& p) {
    vertices.push_back(p);
    return static_cast<int>(vertices.size()) - 1;
  }
};

/// Cuts a surface along the outline of a patch, and keeps the part on the patch.
class PatchCutter {
 public:
  PatchCutter(const TriangleMesh& skin, const SkinPatch& patch) : skin_(skin), patch_(patch) {}

  GrowingMesh cut() {
    for (Eigen::Index t = 0; t < skin_.triangles.cols(); ++t) cut_triangle(skin_.triangles.col(t));
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] bool is_on(int vertex) const {
    return on_patch(patch_, skin_.vertices.col(vertex));
  }

  /// Returns the vertex of the mesh for a vertex of the skin; adds it on first use.
  int mesh_vertex(int vertex) {
    const auto [entry, is_new] = corners_.emplace(vertex, 0);
    if (is_new) entry->second = mesh_.add(skin_.vertices.col(vertex));
    return entry->second;
  }

  /// Finds the point where the outline crosses the edge from a vertex on the patch to one off it.
  int crossing(int on, int off) {
    // Triangles share edges: compute each crossing once.
    const auto [entry, is_new] = crossings_.emplace(std::pair(on, off), 0);
    if (!is_new) return entry->second;
    // Bisect the edge.
    Eigen::Vector3d inside = skin_.vertices.col(on), outside = skin_.vertices.col(off);
    constexpr int kOutlineBisections = 20;  // resolves 1e-6 of the edge
    for (int i = 0; i < kOutlineBisections; ++i) {
      const Eigen::Vector3d middle = (inside + outside) / 2;
      (on_patch(patch_, middle) ? inside : outside) = middle;
    }
    // Use the vertex itself if the outline runs through it.
    const Eigen::Vector3d corner = skin_.vertices.col(on);
    entry->second =
        (inside - corner).norm() < kCornerTolerance ? mesh_vertex(on) : mesh_.add(inside);
    return entry->second;
  }

  /// Adds the part of a triangle on the patch, a polygon of up to four corners.
  void cut_triangle(const Eigen::Vector3i& triangle) {
    // Walk around the triangle, and add vertices on the patch and crossings of its outline.
    std::vector<int> polygon;
    for (int i = 0; i < 3; ++i) {
      const int a = triangle[i], b = triangle[(i + 1) % 3];
      if (is_on(a)) polygon.push_back(mesh_vertex(a));
      if (is_on(a) != is_on(b)) polygon.push_back(is_on(a) ? crossing(a, b) : crossing(b, a));
    }
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
    // Split the polygon into a fan of triangles.
    for (std::size_t i = 2; i < polygon.size(); ++i)
      mesh_.triangles.emplace_back(polygon[0], polygon[i - 1], polygon[i]);
  }

  const TriangleMesh& skin_;
  const SkinPatch& patch_;
  GrowingMesh mesh_;
  std::map<int, int> corners_;                    // vertex of the skin -> vertex of the mesh
  std::map<std::pair<int, int>, int> crossings_;  // edge of the skin -> vertex of the mesh
};

/// Computes the unit normals of all vertices.
std::vector<Eigen::Vector3d> vertex_normals(const GrowingMesh& mesh) {
  // Sum the normals of the triangles, weighted by area so that slivers hardly count.
  std::vector<Eigen::Vector3d> normals(mesh.vertices.size(), Eigen::Vector3d::Zero());
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const auto corner = [&](int i) { return mesh.vertices[t[i]]; };
    const Eigen::Vector3d n = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    for (int i = 0; i < 3; ++i) normals[t[i]] += n;
  }
  for (Eigen::Vector3d& n : normals)
    if (n.norm() > 0) n.normalize();
  return normals;
}

/// Converts to a TriangleMesh.
TriangleMesh packed(const GrowingMesh& mesh) {
  TriangleMesh out;
  out.vertices.resize(3, static_cast<Eigen::Index>(mesh.vertices.size()));
  out.triangles.resize(3, static_cast<Eigen::Index>(mesh.triangles.size()));
  for (Eigen::Index i = 0; i < out.vertices.cols(); ++i) out.vertices.col(i) = mesh.vertices[i];
  for (Eigen::Index i = 0; i < out.triangles.cols(); ++i) out.triangles.col(i) = mesh.triangles[i];
  return out;
}

/// Adds walls from the raised outline down to the skin: two triangles for each boundary edge.
/// @param below  positions of the vertices on the skin [m]
void add_rim(GrowingMesh& mesh, const std::vector<Eigen::Vector3d>& below) {
  const std::vector<MeshSide> sides = sides_by_edge(packed(mesh));
  std::map<int, int> feet;  // raised vertex -> vertex below it on the skin
  const auto foot_of = [&](int vertex) {
    const auto [entry, is_new] = feet.emplace(vertex, 0);
    if (is_new) entry->second = mesh.add(below[vertex]);
    return entry->second;
  };
  // An edge with a single side is part of the outline.
  for_each_edge(sides, [&](const MeshSide* first, const MeshSide* last) {
    if (last - first != 1) return;
    const int from = first->upwards ? first->low : first->high;
    const int to = first->upwards ? first->high : first->low;
    const int foot_from = foot_of(from), foot_to = foot_of(to);
    mesh.triangles.emplace_back(to, from, foot_from);
    mesh.triangles.emplace_back(to, foot_from, foot_to);
  });
}

}  // namespace

TriangleMesh nail_mesh(const TriangleMesh& skin, const SkinPatch& patch) {
  GrowingMesh mesh = PatchCutter(skin, patch).cut();
  // Raise the cut part along its normals, and close the gap to the skin by a rim.
  const std::vector<Eigen::Vector3d> below = mesh.vertices, normals = vertex_normals(mesh);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    mesh.vertices[i] += kNailHeight * normals[i];
  add_rim(mesh, below);
  return packed(mesh);
}

}  // namespace thenar
