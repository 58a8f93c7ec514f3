#pragma once

/// Search for the parts of a collision surface that lie near a solid.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/collision/collision_tree.h"
#include "geometry/shape.h"

namespace thenar {

/// A point of A's core, seen from B, in B's frame.
struct PatchPoint {
  Eigen::Vector3d core{0, 0, 0};    // [m] (3)
  double distance = 0;              // of the rounded surface there [m]
  Eigen::Vector3d on_b{0, 0, 0};    // nearest point of B's surface [m] (3)
  Eigen::Vector3d normal{0, 0, 1};  // outward of B there, unit (3)
  double radius = 0;                // of the rounding [m]
  bool supports = false;            // NearestSurface::supports
};

/// A piece of a triangle of A that lies near B.
struct PatchPiece {
  Ball ball;                       // around its core [m]
  std::vector<PatchPoint> points;  // those of its points that are near enough, the nearest first
};

/// Parameters of the search.
struct PatchQuery {
  double level = 0;       // points no farther from B than this [m]
  double aim = 0;         // distance to look for at the rim, a little less than the level [m]
  double resolution = 0;  // pieces at the rim are halved down to balls of this radius [m]
  Ball within{{0, 0, 0}, 1e30};  // nothing outside is looked at [m]
  int max_evaluations = 50'000;  // of B's distance
  int halvings = 0;              // of sides that cross the rim, to find where
};

struct PatchPieces {
  std::vector<PatchPiece> pieces;
  bool complete = true;  // the search ended before max_evaluations
};

/// Finds the pieces of A within a level of B's distance.
///
/// A piece with all corners inside the level is kept whole: its corners span it. Others are halved
/// down to the resolution; of those left at the rim the points count that are inside, among them
/// where sides cross the rim, and those nearest to the points of B's edges that corners outside lie
/// over.
[[nodiscard]] PatchPieces near_pieces(const CollisionTree& a, const Pose<double>& X_BA,
                                      const Shape& b, const PatchQuery& query);

}  // namespace thenar
