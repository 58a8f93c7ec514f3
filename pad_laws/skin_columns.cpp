#include "pad_laws/skin_columns.h"

#include <algorithm>
#include <vector>

#include <Eigen/Geometry>

#include "geometry/collision/collision_tree.h"

namespace thenar {
namespace {

constexpr double kMaxPieceLength = 7e-4;  // longest side of the piece of skin of a column [m]
constexpr double kSkinReach = 10e-3;   // distance from the point within which columns are built [m]
constexpr double kSliverArea = 1e-14;  // twice the area below which a piece carries no load [m^2]

/// Splits the triangles near a point into pieces with no side longer than kMaxPieceLength.
std::vector<Eigen::Matrix3d> pieces_near(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  // Begin with all triangles.
  std::vector<Eigen::Matrix3d> todo, pieces;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = mesh.vertices.col(mesh.triangles(i, t));
    todo.push_back(corners);
  }
  // Halve triangles until they are small; drop those out of reach.
  while (!todo.empty()) {
    const Eigen::Matrix3d corners = todo.back();
    todo.pop_back();
    const double size = std::max({(corners.col(0) - corners.col(1)).norm(),
                                  (corners.col(1) - corners.col(2)).norm(),
                                  (corners.col(2) - corners.col(0)).norm()});
    if ((corners.rowwise().mean() - p).norm() > kSkinReach + size) continue;
    if (size <= kMaxPieceLength) {
      pieces.push_back(corners);
      continue;
    }
    for (const Eigen::Matrix3d& half : internal::bisect_triangle(corners)) todo.push_back(half);
  }
  return pieces;
}

}  // namespace

FoundationColumns skin_columns(const TriangleMesh& skin, const Eigen::Vector3d& p,
                               double thickness) {
  // Reserve one column for each piece of skin.
  const std::vector<Eigen::Matrix3d> pieces = pieces_near(skin, p);
  const auto count = static_cast<Eigen::Index>(pieces.size());
  FoundationColumns columns;
  columns.skin.resize(3, count);
  columns.normal.resize(3, count);
  columns.thickness = Eigen::VectorXd::Constant(count, thickness);
  columns.area.resize(count);
  // Set the centre, normal and area of each column; skip slivers.
  Eigen::Index kept = 0;
  for (const Eigen::Matrix3d& corners : pieces) {
    const Eigen::Vector3d n =
        (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    if (n.norm() < kSliverArea) continue;
    columns.skin.col(kept) = corners.rowwise().mean();
    columns.normal.col(kept) = n.normalized();
    columns.area[kept++] = n.norm() / 2;
  }
  // Release the unused columns.
  columns.skin.conservativeResize(3, kept);
  columns.normal.conservativeResize(3, kept);
  columns.thickness.conservativeResize(kept);
  columns.area.conservativeResize(kept);
  return columns;
}

}  // namespace thenar
