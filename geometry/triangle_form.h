#pragma once

/// A triangle as the search for nearest points wants it.

#include <array>
#include <limits>

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

  /// The point nearest to p. What it finds depends on p and the triangle alone, whatever `limit`
  /// is.
  /// @param limit  a squared distance beyond which it need not be found [m^2]
  /// @return false: it lies beyond; `foot` may hold another point of the triangle
  bool find_foot(const Eigen::Vector3d& p, double limit, FootPoint& foot) const;
};

inline bool TriangleForm::find_foot(const Eigen::Vector3d& p, double limit, FootPoint& foot) const {
  const Eigen::Vector3d from_first = p - corner[0];
  const double height = normal.dot(from_first), upright = height * height;
  if (upright > limit) return false;
  // The nearest point is on the face, or on an edge that has p on its outer side.
  foot.squared = std::numeric_limits<double>::infinity();
  bool over = true;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d arm = p - corner[k];
    const double out = across[k].dot(arm);
    if (out <= 0) continue;
    over = false;
    if (upright + out * out > limit) return false;
    const Eigen::Vector3d edge = corner[(k + 1) % 3] - corner[k];
    const double share = edge.dot(arm) * inverse[k];
    if (share <= 0) {
      const double squared = arm.squaredNorm();
      if (squared < foot.squared) foot = {squared, corner[k], {Feature::kCorner, k}};
    } else if (share >= 1) {
      const int next = (k + 1) % 3;
      const double squared = (p - corner[next]).squaredNorm();
      if (squared < foot.squared) foot = {squared, corner[next], {Feature::kCorner, next}};
    } else {
      const double squared = (arm - share * edge).squaredNorm();
      if (squared < foot.squared) foot = {squared, corner[k] + share * edge, {Feature::kEdge, k}};
    }
  }
  if (over) foot = {upright, p - height * normal, {Feature::kFace, 0}};
  return true;
}

}  // namespace thenar::internal
