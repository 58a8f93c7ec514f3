#pragma once

/// Triangles in boxes in boxes, for nearest-point searches anywhere.

#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "geometry/triangle_form.h"
#include "geometry/triangle_mesh.h"

namespace thenar::internal {

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

  /// Improves on a first guess, whose distance may be infinite. Rounding does not decide what is
  /// left out, so that the answer is the same whatever the guess was.
  [[nodiscard]] NearestTriangle nearest(const Eigen::Vector3d& p, NearestTriangle guess) const;

  /// Puts triangle i in place of `best` if it is nearer.
  void ask(int i, const Eigen::Vector3d& p, NearestTriangle& best) const;

  /// In the order of forms(): the mesh's triangle that stands there.
  [[nodiscard]] const std::vector<int>& order() const { return order_; }
  /// Neighbours in space are neighbours in memory.
  [[nodiscard]] const std::vector<TriangleForm>& forms() const { return forms_; }
  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const { return nodes_.front().box; }

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int first;  // of its triangles
    int count;  // of a leaf's triangles; 0: children are the next node and `second`
    int second;
  };
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
  if (!forms_[static_cast<std::size_t>(i)].find_foot(p, best.limit, foot)) return;
  if (foot.squared > best.foot.squared || (foot.squared == best.foot.squared && i >= best.triangle))
    return;
  best = {foot, i, foot.squared * (1 + relative_) + absolute_};
}

}  // namespace thenar::internal
