#pragma once

/// A surface made of triangles.

#include <Eigen/Core>

namespace thenar {

/// Corners of a triangle stand counterclockwise seen from outside.
struct TriangleMesh {
  Eigen::Matrix3Xd vertices;   // [m] (3, vertices)
  Eigen::Matrix3Xi triangles;  // columns of `vertices` (3, triangles)

  [[nodiscard]] bool empty() const { return triangles.cols() == 0; }
};

}  // namespace thenar
