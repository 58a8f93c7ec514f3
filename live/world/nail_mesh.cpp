#include "live/world/nail_mesh.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace thenar {
namespace {

constexpr double kSamePlace = 1e-8;  // corners of a nail closer than this are one [m]

/// Vertices and triangles that grow.
struct GrowingMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3i> triangles;

  int add(const Eigen::Vector3d& p) {
    vertices.push_back(p);
    return static_cast<int>(vertices.size()) - 1;
  }
};

/// Cuts a surface along the outline of a patch and keeps what lies on it.
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

  int kept(int vertex) {
    const auto [at, fresh] = corners_.emplace(vertex, 0);
    if (fresh) at->second = mesh_.add(skin_.vertices.col(vertex));
    return at->second;
  }

  /// Finds the point where the outline crosses the edge from a vertex on the patch to one off it.
  int crossing(int on, int off) {
    // Triangles share edges, so each crossing is computed once.
    const auto [at, fresh] = crossings_.emplace(std::pair(on, off), 0);
    if (!fresh) return at->second;
    Eigen::Vector3d inside = skin_.vertices.col(on), outside = skin_.vertices.col(off);
    constexpr int kHalvings = 20;
    for (int i = 0; i < kHalvings; ++i) {
      const Eigen::Vector3d middle = (inside + outside) / 2;
      (on_patch(patch_, middle) ? inside : outside) = middle;
    }
    // The outline may run through the vertex itself.
    const Eigen::Vector3d corner = skin_.vertices.col(on);
    at->second = (inside - corner).norm() < kSamePlace ? kept(on) : mesh_.add(inside);
    return at->second;
  }

  /// The part on the patch is a polygon of up to four corners.
  void cut_triangle(const Eigen::Vector3i& triangle) {
    // Walk round the triangle, and add a vertex on the patch or a crossing of its outline.
    std::vector<int> polygon;
    for (int i = 0; i < 3; ++i) {
      const int a = triangle[i], b = triangle[(i + 1) % 3];
      if (is_on(a)) polygon.push_back(kept(a));
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
  std::map<int, int> corners_;                    // vertex of the skin -> of the mesh
  std::map<std::pair<int, int>, int> crossings_;  // edge of the skin -> vertex of the mesh
};

std::vector<Eigen::Vector3d> vertex_normals(const GrowingMesh& mesh) {
  // Sum the normals of triangles weighted by their area, so that slivers hardly count.
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

TriangleMesh packed(const GrowingMesh& mesh) {
  TriangleMesh out;
  out.vertices.resize(3, static_cast<Eigen::Index>(mesh.vertices.size()));
  out.triangles.resize(3, static_cast<Eigen::Index>(mesh.triangles.size()));
  for (Eigen::Index i = 0; i < out.vertices.cols(); ++i) out.vertices.col(i) = mesh.vertices[i];
  for (Eigen::Index i = 0; i < out.triangles.cols(); ++i) out.triangles.col(i) = mesh.triangles[i];
  return out;
}

/// Walls from the raised outline down to the skin: two triangles at each edge of one triangle.
void add_rim(GrowingMesh& mesh, const std::vector<Eigen::Vector3d>& below) {
  // An edge of one triangle alone is part of the outline.
  const std::vector<MeshSide> sides = sides_by_edge(packed(mesh));
  std::map<int, int> feet;  // raised vertex -> its foot on the skin
  const auto foot_of = [&](int vertex) {
    const auto [at, fresh] = feet.emplace(vertex, 0);
    if (fresh) at->second = mesh.add(below[vertex]);
    return at->second;
  };
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
  // Raise it; what it was cut from is where its rim ends.
  const std::vector<Eigen::Vector3d> below = mesh.vertices, normals = vertex_normals(mesh);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    mesh.vertices[i] += kNailHeight * normals[i];
  add_rim(mesh, below);
  return packed(mesh);
}

}  // namespace thenar
