#pragma once

/// Search for the parts of a collision surface that are near a solid.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/collision/collision_tree.h"
#include "geometry/shape.h"

namespace thenar {

/// A point of A's core with the nearest surface of B, in B's frame.
struct PatchPoint {
  Eigen::Vector3d core{0, 0, 0};    // [m] (3)
  double distance = 0;              // distance of the rounded surface from B [m]
  Eigen::Vector3d on_b{0, 0, 0};    // nearest point of B's surface [m] (3)
  Eigen::Vector3d normal{0, 0, 1};  // outward normal of B at on_b, unit (3)
  double radius = 0;                // rounding radius [m]
  bool supports = false;            // NearestSurface::supports
};

/// Returns the point of A's core with the surface of B nearest to it. @param radius  of A there [m]
[[nodiscard]] inline PatchPoint patch_point(const Eigen::Vector3d& core, const NearestSurface& near,
                                            double radius) {
  return {core,   near.distance - radius, core - near.distance * near.normal, near.normal,
          radius, near.supports};
}

/// A piece of a triangle of A that is near B.
struct PatchPiece {
  Ball ball;                       // bounding ball of its core [m]
  std::vector<PatchPoint> points;  // points of it that are near enough, nearest first
};

/// Settings of the search.
struct PatchQuery {
  double level = 0;       // maximum distance of points from B [m]
  double aim = 0;         // distance sought at the boundary, slightly less than the level [m]
  double resolution = 0;  // radius down to which pieces at the boundary are halved [m]
  Ball within{{0, 0, 0}, 1e30};  // ball outside of which nothing is evaluated [m]
  int max_evaluations = 50'000;  // maximum number of distance evaluations of B
  int halvings = 0;              // number of bisections of sides that cross the boundary
};

/// Result of near_pieces().
struct PatchPieces {
  std::vector<PatchPiece> pieces;
  bool complete = true;  // true: the search ended before max_evaluations
};

/// Finds the pieces of A within a level of B's distance.
///
/// A piece with all corners inside the level is kept whole: its corners span it. Others are halved
/// down to the resolution. For pieces left at the boundary only points inside the level count,
/// including those where sides cross the boundary, and those nearest to the points of B's edges
/// that are opposite to corners outside.
[[nodiscard]] PatchPieces near_pieces(const CollisionTree& a, const Pose<double>& X_BA,
                                      const Shape& b, const PatchQuery& query);

}  // namespace thenar
