#pragma once

/// Signed distance of two solids.

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/collision/collision_tree.h"
#include "geometry/solid.h"

namespace thenar {

/// The nearest pair of points of two solids, in world.
struct SignedDistance {
  double distance;         // negative: deepest point of A in B found [m]
  double error;            // the distance is true within this [m]
  Eigen::Vector3d on_a;    // [m] (3)
  Eigen::Vector3d on_b;    // [m] (3)
  Eigen::Vector3d normal;  // unit, outward of B at on_b (3)
  int triangle = -1;       // of A's touch body that has on_a
  int evaluations = 0;     // of B's distance
};

/// Accuracy of the search.
struct SignedDistanceOptions {
  double tolerance = 5e-5;        // error allowed, besides that of B's distance [m]
  double relative = 0;            // error allowed as a share of the distance, if that is more [1]
  double cutoff = 1e30;           // distances beyond this need not be exact [m]
  int start = -1;                 // triangle to try first: SignedDistance::triangle of a near pose
  int max_evaluations = 200'000;  // of B's distance; then the error is as large as it is
  Ball within{{0, 0, 0}, 1e30};   // what of A lies outside does not count; B's frame [m]
};

/// Finds the point of A deepest in, or nearest to, B by branch and bound.
///
/// The distance of B changes by no more than the way gone, so nothing in a ball of radius r about c
/// is nearer than  d(c) - r.  A triangle is searched twice: in the ball around it, and in the ball
/// about a point lifted off B, through the triangle's corners, which is nearly flat there; where
/// flat faces lie on each other nothing is left to be divided. Triangles are halved until the best
/// point is within the tolerance of the lowest bound.
///
/// The core of a capsule is searched along itself: beside a convex solid between supporting planes
/// (ConvexBracket), beside other solids with exact distances between empty balls (BallPair).
///
/// A rounded triangle of radius r is as far as its core less r. Where A encloses B without touching
/// it the distance is positive: hands do not swallow objects. Beyond `cutoff` the distance is a
/// lower bound, with the nearest points seen so far; its error is then infinite.
///
/// @param a  from collision_tree(); build it once
/// @throws InputError if a pose is not finite, B has no shape, or the tolerance is not positive.
[[nodiscard]] SignedDistance signed_distance(const CollisionTree& a, const Pose<double>& X_WA,
                                             const Solid& b, const Pose<double>& X_WB,
                                             const SignedDistanceOptions& options = {});

/// The same against a shape, in its frame.
[[nodiscard]] SignedDistance signed_distance(const CollisionTree& a, const Pose<double>& X_BA,
                                             const Shape& b,
                                             const SignedDistanceOptions& options = {});

/// The same for one question: sorts A's collision surface first, which takes longer than the
/// search.
[[nodiscard]] SignedDistance signed_distance(const Solid& a, const Pose<double>& X_WA,
                                             const Solid& b, const Pose<double>& X_WB,
                                             double tolerance = 5e-5, double cutoff = 1e30);

}  // namespace thenar
