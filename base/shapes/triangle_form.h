#pragma once

/// A triangle as the search for nearest points wants it.

#include <array>

#include <Eigen/Core>

namespace thenar::internal {

/// What of a triangle is nearest: its face, an edge or a corner.
struct Feature {
  enum Kind { kFace, kEdge, kCorner } kind = kFace;
  int k = 0;  // edge from corner k to the next, or corner k
};

/// The point of a triangle nearest to another.
struct FootPoint {
  double squared;      // distance [m^2]
  Eigen::Vector3d at;  // [m] (3)
  Feature feature;
};

/// Corners, unit normal, and for each edge its outward unit normal in the plane.
struct TriangleForm {
  std::array<Eigen::Vector3d, 3> corner;  // [m]
  Eigen::Vector3d normal;                 // (3)
  std::array<Eigen::Vector3d, 3> across;  // of edge k, from corner k to the next (3)
  std::array<double, 3> inverse;          // 1 / squared length of edge k [1/m^2]

  /// @param a, b, c  corners, not in line [m]
  [[nodiscard]] static TriangleForm of(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                       const Eigen::Vector3d& c);

  /// Improves `best` if this triangle is nearer to p; true if so.
  bool improve(const Eigen::Vector3d& p, FootPoint& best) const;
};

inline bool TriangleForm::improve(const Eigen::Vector3d& p, FootPoint& best) const {
  const Eigen::Vector3d from_first = p - corner[0];
  const double height = normal.dot(from_first);
  if (height * height >= best.squared) return false;
  // The nearest point is on the face, or on an edge that has p on its outer side.
  bool over = true, better = false;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d arm = p - corner[k];
    const double out = across[k].dot(arm);
    if (out <= 0) continue;
    over = false;
    if (out * out >= best.squared) return better;
    const Eigen::Vector3d edge = corner[(k + 1) % 3] - corner[k];
    const double share = edge.dot(arm) * inverse[k];
    FootPoint foot;
    if (share <= 0) {
      foot = {arm.squaredNorm(), corner[k], {Feature::kCorner, k}};
    } else if (share >= 1) {
      const int next = (k + 1) % 3;
      foot = {(p - corner[next]).squaredNorm(), corner[next], {Feature::kCorner, next}};
    } else {
      const Eigen::Vector3d at = corner[k] + share * edge;
      foot = {(p - at).squaredNorm(), at, {Feature::kEdge, k}};
    }
    if (foot.squared < best.squared) {
      best = foot;
      better = true;
    }
  }
  if (!over) return better;
  best = {height * height, p - height * normal, {Feature::kFace, 0}};
  return true;
}

}  // namespace thenar::internal
