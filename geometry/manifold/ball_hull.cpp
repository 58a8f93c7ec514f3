#include "geometry/manifold/ball_hull.h"

#include <algorithm>
#include <cmath>

namespace thenar::internal {

constexpr int kMaxAlternations = 100;     // maximum number of steps between two tapered hulls
constexpr double kSameParameter = 1e-13;  // change of parameters at which they end [1]

using Eigen::Vector3d;

BallHull::BallHull(const CollisionPart& part, const Pose<double>& X)
    : p0(X.p - part.half_length * X.R.col(2)),
      axis(2 * part.half_length * X.R.col(2)),
      r0(part.radius[0]),
      radius_increase(part.radius[1] - part.radius[0]),
      length(2 * part.half_length) {}

BallHull::BallHull(const Vector3d& from, const Vector3d& to_other)
    : p0(from), axis(to_other), r0(0), radius_increase(0), length(to_other.norm()) {}

double BallHull::nearest_parameter(const Vector3d& q) const {
  if (length == 0) return 0;
  const Vector3d arm = q - p0;
  const double z = arm.dot(axis) / length;
  if (radius_increase == 0) return z / length;
  // The surface of a tapered hull leans by alpha against the axis.
  const double sine = -radius_increase / length,
               cosine = std::sqrt(std::max(1e-30, (1 - sine) * (1 + sine)));
  const double rho = std::sqrt(std::max(0.0, arm.squaredNorm() - z * z));
  return (z - rho * sine / cosine) / length;
}

SegmentParameters nearest_balls(const BallHull& a, const BallHull& b) {
  // Start at the nearest points of the axes; with tapered hulls, alternate between them.
  SegmentParameters at = nearest_on_segments(a.p0, a.axis, b.p0, b.axis);
  if (a.radius_increase == 0 && b.radius_increase == 0) return at;
  for (int i = 0; i < kMaxAlternations; ++i) {
    const SegmentParameters last = at;
    at.s = std::clamp(a.nearest_parameter(b.centre(at.t)), 0.0, 1.0);
    at.t = std::clamp(b.nearest_parameter(a.centre(at.s)), 0.0, 1.0);
    if (std::abs(at.s - last.s) + std::abs(at.t - last.t) < kSameParameter) break;
  }
  return at;
}

ManifoldPoint ball_on_shape(const BallHull& a, const Shape& b, double t) {
  const Vector3d p = a.centre(t);
  const NearestSurface seen = b.nearest(p);
  return {p - a.radius(t) * seen.normal, p - seen.distance * seen.normal, seen.normal,
          seen.distance - a.radius(t)};
}

}  // namespace thenar::internal
