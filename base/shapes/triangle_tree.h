#pragma once

/// Triangles in boxes in boxes, for nearest-point searches anywhere.

#include <vector>

#include <Eigen/Geometry>

#include "base/shapes/triangle_form.h"
#include "base/shapes/triangle_mesh.h"

namespace thenar::internal {

/// The nearest triangle, by its place in TriangleTree::order().
struct NearestTriangle {
  FootPoint foot;
  int triangle = -1;
};

class TriangleTree {
 public:
  /// @param mesh  triangles whose corners are not in line, at least one
  explicit TriangleTree(const TriangleMesh& mesh);

  /// Improves on a first guess, whose distance may be infinite.
  [[nodiscard]] NearestTriangle nearest(const Eigen::Vector3d& p, NearestTriangle guess) const;

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

  std::vector<Node> nodes_;
  std::vector<int> order_;
  std::vector<TriangleForm> forms_;
};

}  // namespace thenar::internal
