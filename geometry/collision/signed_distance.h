#pragma once

/// Signed distance of two solids.

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/collision/collision_tree.h"
#include "geometry/solid.h"

namespace thenar {

/// The nearest pair of points of two solids A and B, in the frame to which the poses lead: world,
/// or that of B for the overload with a Shape.
///
/// The distance is the least distance of a point of A from B. Where the solids overlap it is minus
/// the greatest depth of a point of A in B: not the shortest translation that separates them, and
/// another number if A and B change places.
struct SignedDistance {
  double distance;         // [m]
  double error;            // the distance is true within this [m]
  Eigen::Vector3d on_a;    // point of A [m] (3)
  Eigen::Vector3d on_b;    // point of B [m] (3)
  Eigen::Vector3d normal;  // unit, outward of B at on_b (3)
  int triangle = -1;    // entry of CollisionTree::triangles of A with on_a: a good `start` of the
                        // next search
  int evaluations = 0;  // of B's distance
};

/// Accuracy of the search.
struct SignedDistanceOptions {
  double tolerance = 5e-5;        // error allowed, besides that of B's distance, > 0 [m]
  double relative = 0;            // error allowed as a share of the distance, if that is more [1]
  double cutoff = 1e30;           // distances beyond this need not be exact [m]
  int start = -1;                 // triangle to try first: SignedDistance::triangle of a near pose
  int max_evaluations = 200'000;  // of B's distance; then the error is as large as it is
  Ball within{{0, 0, 0}, 1e30};   // only the part of A in this ball is searched; B's frame [m]
};

/// Finds the point of A deepest in, or nearest to, B by branch and bound.
///
/// The distance d from B has a slope of at most 1, so no point in a ball of radius r about c is
/// nearer than  d(c) - r.  Triangles are halved until the best point is within the tolerance of the
/// lowest bound. A triangle swept by a ball of radius r is nearer by r than the triangle itself.
///
/// Where A encloses B without touching it the distance is positive. Beyond `cutoff` the distance is
/// a lower bound, with the nearest points seen so far; its error is then infinite.
///
/// @param a  from collision_tree(); build it once
/// @throws InputError if a pose is not finite, B has no shape, or the tolerance is not positive.
[[nodiscard]] SignedDistance signed_distance(const CollisionTree& a, const Pose<double>& X_WA,
                                             const Solid& b, const Pose<double>& X_WB,
                                             const SignedDistanceOptions& options = {});

/// Finds the signed distance of A from a shape B; points and normal are in the frame of B.
[[nodiscard]] SignedDistance signed_distance(const CollisionTree& a, const Pose<double>& X_BA,
                                             const Shape& b,
                                             const SignedDistanceOptions& options = {});

/// Finds the signed distance without a given tree: it builds the tree of A at each call, which
/// takes longer than the search.
/// @param tolerance  as of SignedDistanceOptions [m];  @param cutoff  the same [m]
[[nodiscard]] SignedDistance signed_distance(const Solid& a, const Pose<double>& X_WA,
                                             const Solid& b, const Pose<double>& X_WB,
                                             double tolerance = 5e-5, double cutoff = 1e30);

}  // namespace thenar
