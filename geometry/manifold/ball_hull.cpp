#include "geometry/manifold/ball_hull.h"

#include <algorithm>
#include <cmath>

namespace thenar::internal {

using Eigen::Vector3d;

BallHull::BallHull(const CollisionPart& part, const Pose<double>& X)
    : p0(X.p - part.half_length * X.R.col(2)),
      way(2 * part.half_length * X.R.col(2)),
      r0(part.radius[0]),
      grow(part.radius[1] - part.radius[0]),
      length(2 * part.half_length) {}

BallHull::BallHull(const Vector3d& from, const Vector3d& to_other)
    : p0(from), way(to_other), r0(0), grow(0), length(to_other.norm()) {}

double BallHull::foot(const Vector3d& q) const {
  if (length == 0) return 0;
  const Vector3d arm = q - p0;
  const double z = arm.dot(way) / length;
  if (grow == 0) return z / length;
  // The side leans by alpha against the axis.
  const double sine = -grow / length, cosine = std::sqrt(std::max(1e-30, (1 - sine) * (1 + sine)));
  const double rho = std::sqrt(std::max(0.0, arm.squaredNorm() - z * z));
  return (z - rho * sine / cosine) / length;
}

SegmentPlaces nearest_balls(const BallHull& a, const BallHull& b) {
  SegmentPlaces at = nearest_on_segments(a.p0, a.way, b.p0, b.way);
  if (a.grow == 0 && b.grow == 0) return at;
  for (int i = 0; i < 100; ++i) {
    const SegmentPlaces last = at;
    at.s = std::clamp(a.foot(b.at(at.t)), 0.0, 1.0);
    at.t = std::clamp(b.foot(a.at(at.s)), 0.0, 1.0);
    if (std::abs(at.s - last.s) + std::abs(at.t - last.t) < 1e-13) break;
  }
  return at;
}

ManifoldPoint ball_on_shape(const BallHull& a, const Shape& b, double t) {
  const Vector3d p = a.at(t);
  const NearestSurface seen = b.nearest(p);
  ManifoldPoint point;
  point.on_a = p - a.radius(t) * seen.normal;
  point.on_b = p - seen.distance * seen.normal;
  point.normal = seen.normal;
  point.gap = seen.distance - a.radius(t);
  return point;
}

}  // namespace thenar::internal
