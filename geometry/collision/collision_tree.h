#pragma once

/// Bounding volume hierarchy of balls over a solid's collision surface (Solid::touch).

#include <array>
#include <vector>

#include <Eigen/Core>

#include "geometry/solid.h"

namespace thenar {

/// A solid sphere.
struct Ball {
  Eigen::Vector3d c{0, 0, 0};  // centre [m] (3)
  double r = 0;                // [m]
};

/// A triangle swept by a ball; it may be a segment or a point.
struct SweptTriangle {
  Eigen::Matrix3d corners;     // corners, one per column [m] (3, 3)
  double radius = 0;           // radius of the ball that sweeps it [m]
  Eigen::Vector3d n{0, 0, 0};  // outward unit normal; 0 for a segment or a point (3)
  int source = -1;             // index of the triangle in the order of Solid::collision
};

/// Node of the tree: two children, or one triangle.
struct CollisionNode {
  Ball ball;  // bounding ball of the swept triangles below it
  int left = -1;
  int right = -1;
  int triangle = -1;  // entry of CollisionTree::triangles; -1: an inner node
};

/// Bounding volume hierarchy, constant after construction. The first node is the root.
struct CollisionTree {
  std::vector<SweptTriangle> triangles;
  std::vector<CollisionNode> nodes;
};

/// Builds the hierarchy of a solid's collision surface by median splits along the longest side.
/// Triangles of meshes that enclose nothing are left out.
/// @throws InputError if it has no triangle, or one that is not finite.
[[nodiscard]] CollisionTree collision_tree(const Solid& solid);

namespace internal {

/// Computes the smallest ball around three points, which may coincide or be collinear.
/// @param corners  columns [m] (3, 3)
[[nodiscard]] Ball smallest_ball(const Eigen::Matrix3d& corners);

/// Returns the point of a triangle nearest to p; the triangle may be a segment or a point.
/// @param corners  columns [m] (3, 3);  @param p  [m] (3)
[[nodiscard]] Eigen::Vector3d nearest_in_triangle(const Eigen::Matrix3d& corners,
                                                  const Eigen::Vector3d& p);

/// Returns the point of a segment nearest to p; its ends may coincide.
[[nodiscard]] Eigen::Vector3d nearest_in_segment(const Eigen::Vector3d& from,
                                                 const Eigen::Vector3d& to,
                                                 const Eigen::Vector3d& p);

/// Bisects a triangle from the middle of its longest side to the opposite corner.
/// @param corners  columns [m] (3, 3)
[[nodiscard]] std::array<Eigen::Matrix3d, 2> bisect_triangle(const Eigen::Matrix3d& corners);

}  // namespace internal

}  // namespace thenar
