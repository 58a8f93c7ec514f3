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

/// The nearest feature of a triangle: its face, an edge or a corner.
struct Feature {
  enum Kind { kFace, kEdge, kCorner } kind = kFace;
  int k = 0;  // number of the edge from corner k to the next, or of the corner
};

/// The point of a triangle nearest to another point.
struct FootPoint {
  double squared;         // squared distance [m^2]
  Eigen::Vector3d point;  // [m] (3)
  Feature feature;
};

/// A triangle prepared for searches: corners, unit normal, and the outward normals of its edges.
struct TriangleForm {
  std::array<Eigen::Vector3d, 3> corner;  // [m]
  Eigen::Vector3d normal;                 // (3)
  /// Outward unit normal of edge k in the plane, from corner k to the next (3).
  std::array<Eigen::Vector3d, 3> across;
  std::array<double, 3> inverse;  // 1 / squared length of edge k [1/m^2]

  /// Prepares a triangle. @param a, b, c  corners, not collinear [m]
  [[nodiscard]] static TriangleForm from_corners(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                                 const Eigen::Vector3d& c);

  /// Finds the point nearest to p. The result depends only on p and the triangle, and not on
  /// `limit`.
  /// @param limit  squared distance beyond which the search may end [m^2]
  /// @return false: it is beyond; `foot` may hold another point of the triangle
  bool find_foot(const Eigen::Vector3d& p, double limit, FootPoint& foot) const;
};

inline bool TriangleForm::find_foot(const Eigen::Vector3d& p, double limit, FootPoint& foot) const {
  // Exclude far triangles by their plane.
  const Eigen::Vector3d from_first = p - corner[0];
  const double height = normal.dot(from_first), upright = height * height;
  if (upright > limit) return false;
  // Find the nearest point on the face, or on an edge with p on its outer side.
  foot.squared = std::numeric_limits<double>::infinity();
  bool over_face = true;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d arm = p - corner[k];
    const double out = across[k].dot(arm);
    if (out <= 0) continue;
    over_face = false;
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
  if (over_face) foot = {upright, p - height * normal, {Feature::kFace, 0}};
  return true;
}

/// The nearest triangle, by its position in TriangleTree::order(); of several at the same computed
/// distance the first.
struct NearestTriangle {
  FootPoint foot{std::numeric_limits<double>::infinity(), {}, {}};
  int triangle = -1;
  double limit = std::numeric_limits<double>::infinity();  // squared distance beyond which nothing
                                                           // is nearer [m^2]
};

/// Tree of bounding boxes over the triangles of a mesh.
class TriangleTree {
 public:
  /// @param mesh  at least one triangle, none with collinear corners
  explicit TriangleTree(const TriangleMesh& mesh);

  /// Finds the nearest triangle from a first guess, whose distance may be infinite. Triangles are
  /// excluded with a margin for rounding, so that the result does not depend on the guess.
  [[nodiscard]] NearestTriangle nearest(const Eigen::Vector3d& p, NearestTriangle guess) const;

  /// Replaces `best` by triangle i if that is nearer.
  void update_nearest(int i, const Eigen::Vector3d& p, NearestTriangle& best) const;

  /// Returns the number in the mesh of each entry of forms().
  [[nodiscard]] const std::vector<int>& order() const { return order_; }
  /// Returns the triangles in an order in which neighbours in space are neighbours in memory.
  [[nodiscard]] const std::vector<TriangleForm>& forms() const { return forms_; }
  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const { return nodes_.front().box; }

  /// Node of the tree, a leaf or with two children.
  struct Node {
    Eigen::AlignedBox3d box;
    int first;  // first of its triangles
    int count;  // number of a leaf's triangles; 0: children are the next node and `second`
    int second;
  };
  /// Returns the nodes, the root first.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

 private:
  int build(int first, int last, const std::vector<Eigen::AlignedBox3d>& boxes);

  // Rounding errors: a squared distance may be computed larger than another that it is below.
  double relative_ = 0;  // relative error [1]
  double absolute_ = 0;  // absolute error [m^2]
  std::vector<Node> nodes_;
  std::vector<int> order_;
  std::vector<TriangleForm> forms_;
};

inline void TriangleTree::update_nearest(int i, const Eigen::Vector3d& p,
                                         NearestTriangle& best) const {
  FootPoint foot;
  if (!forms_[i].find_foot(p, best.limit, foot)) return;
  if (foot.squared > best.foot.squared || (foot.squared == best.foot.squared && i >= best.triangle))
    return;
  best = {foot, i, foot.squared * (1 + relative_) + absolute_};
}

}  // namespace thenar::internal
