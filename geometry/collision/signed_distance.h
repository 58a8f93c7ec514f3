#pragma once

/// Signed distance of two solids.

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/collision/collision_tree.h"
#include "geometry/solid.h"

namespace thenar {

/// The nearest pair of points of two solids A and B, in the frame of the poses: world, or that of B
/// for the overload with a Shape.
///
/// The distance is the minimum distance of a point of A from B. If the solids overlap it is minus
/// the maximum depth of a point of A in B, which is not the shortest translation that separates
/// them, and changes if A and B are exchanged.
struct SignedDistance {
  double distance;         // [m]
  double error;            // maximum error of the distance [m]
  Eigen::Vector3d on_a;    // point of A [m] (3)
  Eigen::Vector3d on_b;    // point of B [m] (3)
  Eigen::Vector3d normal;  // unit, outward of B at on_b (3)
  /// Entry of CollisionTree::triangles of A with on_a: a good `start` of the next search.
  int triangle = -1;
  int evaluations = 0;  // number of distance evaluations of B
};

/// Accuracy of the search.
struct SignedDistanceOptions {
  double tolerance = 5e-5;  // absolute error allowed, besides that of B's distance, > 0 [m]
  double relative = 0;      // error allowed relative to the distance, if that is larger [1]
  double cutoff = 1e30;     // distance beyond which a lower bound suffices [m]
  int start = -1;           // triangle to try first: SignedDistance::triangle at a similar pose
  int max_evaluations =
      200'000;  // maximum number of evaluations of B's distance, which may leave a larger error
  Ball within{{0, 0, 0}, 1e30};  // ball in B's frame; only the part of A in it is searched [m]
};

/// Finds the point of A deepest in, or nearest to, B by branch and bound.
///
/// The slope of the distance d from B is at most 1, so no point in a ball of radius r about c is
/// nearer than  d(c) - r.  Triangles are halved until the best point is within the tolerance of the
/// lowest bound. The radius of a ball that sweeps a triangle is subtracted from its distance.
///
/// If A encloses B without touching it the distance is positive. Beyond `cutoff` the distance is a
/// lower bound, with the nearest points found so far; its error is then infinite.
///
/// @param a  result of collision_tree(), built once
/// @throws InputError if a pose is not finite, B has no shape, or the tolerance is not positive.
[[nodiscard]] SignedDistance signed_distance(const CollisionTree& a, const Pose<double>& X_WA,
                                             const Solid& b, const Pose<double>& X_WB,
                                             const SignedDistanceOptions& options = {});

/// Computes the signed distance of A from a shape B; points and normal are in the frame of B.
[[nodiscard]] SignedDistance signed_distance(const CollisionTree& a, const Pose<double>& X_BA,
                                             const Shape& b,
                                             const SignedDistanceOptions& options = {});

/// Computes the signed distance without a given tree: it builds the tree of A in each call, which
/// takes longer than the search.
/// @param tolerance, cutoff  settings of SignedDistanceOptions [m]
[[nodiscard]] SignedDistance signed_distance(const Solid& a, const Pose<double>& X_WA,
                                             const Solid& b, const Pose<double>& X_WB,
                                             double tolerance = 5e-5, double cutoff = 1e30);

}  // namespace thenar
