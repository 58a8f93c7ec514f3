#pragma once

/// The hull of two balls: spheres, capsules and tapered capsules, and what is nearest to them.

#include <Eigen/Core>

#include "geometry/manifold/contact_manifold.h"
#include "geometry/manifold/near_features.h"
#include "geometry/manifold/part_pair.h"

namespace thenar::internal {

/// The hull of two balls, somewhere. Its balls are numbered by t in [0, 1] along the axis.
struct BallHull {
  Eigen::Vector3d p0, way;  // centre of the lower ball, and from there to the upper one [m] (3)
  double r0, grow;          // radius of the lower ball, and by how much the upper one is larger [m]
  double length;            // of the way [m]

  /// @param part  of form kRound, placed by X
  BallHull(const CollisionPart& part, const Pose<double>& X);
  /// A segment, or a point, without radius.
  BallHull(const Eigen::Vector3d& from, const Eigen::Vector3d& to_other);

  [[nodiscard]] Eigen::Vector3d at(double t) const { return p0 + t * way; }
  [[nodiscard]] double radius(double t) const { return r0 + t * grow; }

  /// Returns the place on the axis of the ball nearest to a point, as if the axis were endless.
  [[nodiscard]] double foot(const Eigen::Vector3d& q) const;
};

/// The nearest balls of two hulls: those of the axes, and where radii change, one after the other
/// from there.
[[nodiscard]] SegmentPlaces nearest_balls(const BallHull& a, const BallHull& b);

/// Features of a ball on the axis, for FeatureKind: the lower end, the upper end, or between.
inline constexpr int kEndLower = 0, kEndUpper = 1, kBetween = 2;
[[nodiscard]] inline int feature_at(double t) {
  return t <= 0 ? kEndLower : t >= 1 ? kEndUpper : kBetween;
}

/// The contact of the ball at t with the surface of a shape that is nearest to its centre, without
/// a feature.
[[nodiscard]] ManifoldPoint ball_on_shape(const BallHull& a, const Shape& b, double t);

}  // namespace thenar::internal
