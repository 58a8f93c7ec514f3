#include "geometry/triangle_mesh.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

namespace thenar {

using Eigen::Vector3d;

double area_of(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles.colwise()) {
    const Vector3d a = mesh.vertices.col(t(0));
    area += (mesh.vertices.col(t(1)) - a).cross(mesh.vertices.col(t(2)) - a).norm() / 2;
  }
  return area;
}

Vector3d principal_extents(const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd r = points.colwise() - Vector3d(points.rowwise().mean());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(r * r.transpose());
  const Eigen::Matrix3Xd along = axes.eigenvectors().transpose() * r;
  return along.rowwise().maxCoeff() - along.rowwise().minCoeff();
}

void move_by(TriangleMesh& mesh, const Pose<double>& X) {
  mesh.vertices = ((X.R * mesh.vertices).colwise() + X.p).eval();
}

std::vector<MeshSide> sides_by_edge(const TriangleMesh& mesh) {
  // Distribute sides by their lower vertex; few share one, so that the rest is quickly sorted.
  const auto edge_of = [&](Eigen::Index t, int k) {
    return std::minmax({mesh.triangles(k, t), mesh.triangles((k + 1) % 3, t)});
  };
  std::vector<int> first(static_cast<std::size_t>(mesh.vertices.cols()) + 1, 0);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) ++first[static_cast<std::size_t>(edge_of(t, k).first) + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<MeshSide> sides(static_cast<std::size_t>(mesh.triangles.size()));
  std::vector<int> next = first;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = edge_of(t, k);
      sides[next[low]++] = {low, high, static_cast<int>(t), k, mesh.triangles(k, t) == low};
    }
  // Sort stably by the other vertex, which keeps the order of triangles and sides.
  for (std::size_t i = 0; i + 1 < first.size(); ++i)
    std::stable_sort(sides.begin() + first[i], sides.begin() + first[i + 1],
                     [](const MeshSide& a, const MeshSide& b) { return a.high < b.high; });
  return sides;
}

Eigen::Matrix3Xi neighbours_across(const TriangleMesh& mesh) {
  Eigen::Matrix3Xi across = Eigen::Matrix3Xi::Constant(3, mesh.triangles.cols(), -1);
  for_each_edge(sides_by_edge(mesh), [&](const MeshSide* first, const MeshSide* last) {
    if (last - first != 2) return;
    across(first->side, first->triangle) = first[1].triangle;
    across(first[1].side, first[1].triangle) = first->triangle;
  });
  return across;
}

}  // namespace thenar
