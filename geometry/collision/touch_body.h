#pragma once

/// A solid's touch surface, sorted into a tree of spheres for searches.

#include <vector>

#include <Eigen/Core>

#include "geometry/solid.h"

namespace thenar {

/// A sphere around something.
struct Ball {
  Eigen::Vector3d c{0, 0, 0};  // centre [m] (3)
  double r = 0;                // [m]
};

/// A triangle swept by a ball; it may be a segment or a point.
struct TouchTriangle {
  Eigen::Matrix3d corners;     // columns [m] (3, 3)
  double radius = 0;           // of the ball that sweeps it [m]
  Eigen::Vector3d n{0, 0, 0};  // unit, outward; 0 for a segment or a point (3)
};

/// Node of the tree: two children, or one triangle.
struct TouchNode {
  Ball ball;  // holds the swept triangles below it
  int left = -1;
  int right = -1;
  int triangle = -1;  // entry of TouchBody::triangles; -1: it has children
};

/// Constant once built. The first node is the root.
struct TouchBody {
  std::vector<TouchTriangle> triangles;
  std::vector<TouchNode> nodes;
};

/// Sorts the touch surface of a solid: median splits along the longest side.
/// @throws InputError if it has no triangle, or one that is not finite.
[[nodiscard]] TouchBody touch_body(const Solid& solid);

/// The smallest ball around three points, which may coincide or stand in line.
/// @param corners  columns [m] (3, 3)
[[nodiscard]] Ball smallest_ball(const Eigen::Matrix3d& corners);

}  // namespace thenar
