#pragma once

/// Tree of boxes over triangles, for nearest-point searches.

#include <array>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/triangle_mesh.h"

namespace thenar::internal {

// A triangle in the form that the search needs.

/// The feature of a triangle that is nearest: its face, an edge or a corner.
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

  /// Finds the point nearest to p. The result depends on p and the triangle alone, whatever `limit`
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

/// The nearest triangle, by its place in TriangleTree::order(); of several at the same computed
/// distance the first.
struct NearestTriangle {
  FootPoint foot{std::numeric_limits<double>::infinity(), {}, {}};
  int triangle = -1;
  double limit = std::numeric_limits<double>::infinity();  // beyond it nothing is nearer [m^2]
};

class TriangleTree {
 public:
  /// @param mesh  triangles whose corners are not in line, at least one
  explicit TriangleTree(const TriangleMesh& mesh);

  /// Improves on a first guess, whose distance may be infinite. Triangles are left out with a
  /// margin for rounding, so that the answer is the same whatever the guess was.
  [[nodiscard]] NearestTriangle nearest(const Eigen::Vector3d& p, NearestTriangle guess) const;

  /// Replaces `best` by triangle i if that is nearer.
  void ask(int i, const Eigen::Vector3d& p, NearestTriangle& best) const;

  /// Returns for each of forms() the number of the mesh's triangle.
  [[nodiscard]] const std::vector<int>& order() const { return order_; }
  /// Neighbours in space are neighbours in memory.
  [[nodiscard]] const std::vector<TriangleForm>& forms() const { return forms_; }
  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const { return nodes_.front().box; }

  struct Node {
    Eigen::AlignedBox3d box;
    int first;  // of its triangles
    int count;  // of a leaf's triangles; 0: children are the next node and `second`
    int second;
  };
  /// The root first.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

 private:
  int build(int first, int last, const std::vector<Eigen::AlignedBox3d>& boxes);

  // How far above a squared distance another may be computed that is in truth below it.
  double relative_ = 0;  // of it [1]
  double absolute_ = 0;  // [m^2]
  std::vector<Node> nodes_;
  std::vector<int> order_;
  std::vector<TriangleForm> forms_;
};

inline void TriangleTree::ask(int i, const Eigen::Vector3d& p, NearestTriangle& best) const {
  FootPoint foot;
  if (!forms_[i].find_foot(p, best.limit, foot)) return;
  if (foot.squared > best.foot.squared || (foot.squared == best.foot.squared && i >= best.triangle))
    return;
  best = {foot, i, foot.squared * (1 + relative_) + absolute_};
}

}  // namespace thenar::internal
