#pragma once

/// Hull of two balls: spheres, capsules and tapered capsules, and points nearest to them.

#include <Eigen/Core>

#include "geometry/manifold/contact_manifold.h"
#include "geometry/manifold/near_features.h"
#include "geometry/manifold/part_pair.h"

namespace thenar::internal {

/// Hull of two balls in a given frame. Its balls are parametrized by t in [0, 1] along the axis.
struct BallHull {
  Eigen::Vector3d p0,
      axis;  // centre of the lower ball, and vector to that of the upper one [m] (3)
  double r0, radius_increase;  // radius of the lower ball, and how much larger the upper one is [m]
  double length;               // length of the axis [m]

  /// @param part  of form kRound, placed by X
  BallHull(const CollisionPart& part, const Pose<double>& X);
  /// Builds a segment, or a point, without radius.
  BallHull(const Eigen::Vector3d& from, const Eigen::Vector3d& to_other);

  [[nodiscard]] Eigen::Vector3d centre(double t) const { return p0 + t * axis; }
  [[nodiscard]] double radius(double t) const { return r0 + t * radius_increase; }

  /// Returns the parameter of the ball nearest to a point, on the infinite axis.
  [[nodiscard]] double nearest_parameter(const Eigen::Vector3d& q) const;
};

/// Finds the nearest balls of two hulls: those nearest on the axes and, where radii change, by
/// alternating steps from there.
[[nodiscard]] SegmentParameters nearest_balls(const BallHull& a, const BallHull& b);

/// Features of a ball on the axis, for FeatureKind: the lower end, the upper end, or in between.
inline constexpr int kEndLower = 0, kEndUpper = 1, kBetween = 2;
[[nodiscard]] inline int axis_feature(double t) {
  return t <= 0 ? kEndLower : t >= 1 ? kEndUpper : kBetween;
}

/// Returns the contact of the ball at t with the nearest surface of a shape, without a feature.
[[nodiscard]] ManifoldPoint ball_on_shape(const BallHull& a, const Shape& b, double t);

}  // namespace thenar::internal
