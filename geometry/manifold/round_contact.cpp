#include "geometry/manifold/round_contact.h"

#include <algorithm>
#include <cmath>

#include "geometry/collision/segment_bounds.h"
#include "geometry/manifold/ball_hull.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

constexpr double kMiddleGain = 1e-7;   // gap by which the minimum must be nearer than the ends [m]
constexpr double kSameCentre = 1e-13;  // distance of centres below which it has no direction [m]
constexpr double kMinEndCosine = 0.5;  // cosine of an end's normal to that of the minimum [1]
constexpr double kFaceTolerance = 1e-7;  // distance outside of a face that counts as above it [m]

/// Returns a direction from B to A for coincident centres: across both axes, or the last one.
Vector3d any_direction(const BallHull& a, const BallHull& b, const Vector3d& last) {
  Vector3d n = a.axis.cross(b.axis);
  if (n.norm() > 1e-9 * a.length * b.length)
    return n.dot(last) < 0 ? -n.normalized() : n.normalized();
  if (!last.isZero(0)) return last;
  const BallHull& longer = a.length > b.length ? a : b;
  return longer.length > 0 ? tangents(longer.axis / longer.length).e1 : Vector3d::UnitZ();
}

/// Computes the contact of two balls.
ManifoldPoint ball_on_ball(const BallHull& a, const BallHull& b, const SegmentParameters& at,
                           const PartMemory& memory) {
  const Vector3d p = a.centre(at.s), q = b.centre(at.t), arm = p - q;
  double distance = arm.norm();
  Vector3d n = distance > kSameCentre ? Vector3d(arm / distance) : any_direction(a, b, memory.n);
  // If the axes have crossed in an overlap, the normal must keep its side.
  const bool between = at.s > 0 && at.s < 1 && at.t > 0 && at.t < 1;
  if (between && memory.overlapped && n.dot(memory.n) < 0) n = -n, distance = -distance;
  return {p - a.radius(at.s) * n, q + b.radius(at.t) * n, n,
          distance - a.radius(at.s) - b.radius(at.t),
          feature_key(FeatureKind::kRounds, axis_feature(at.s), axis_feature(at.t))};
}

}  // namespace

double round_on_round(const CollisionPart& part_a, const CollisionPart& part_b,
                      const Pose<double>& X_BA, double margin, PartMemory& memory,
                      std::vector<ManifoldPoint>& points) {
  const BallHull a(part_a, X_BA), b(part_b, {});
  const SegmentParameters at = nearest_balls(a, b);
  const ManifoldPoint nearest = ball_on_ball(a, b, at, memory);
  const double least = nearest.gap;
  memory.n = nearest.normal;
  memory.overlapped = least < 0;
  if (least > margin) return least;

  // Ends that are beside the other hull.
  double min_end = std::numeric_limits<double>::infinity();
  const auto add_end = [&](const SegmentParameters& end) {
    const ManifoldPoint point = ball_on_ball(a, b, end, memory);
    if (point.normal.dot(nearest.normal) < kMinEndCosine) return;
    min_end = std::min(min_end, point.gap);
    if (point.gap <= margin) points.push_back(point);
  };
  if (a.length > 0 && b.length > 0)
    for (const double end : {0.0, 1.0}) {
      const double t = b.nearest_parameter(a.centre(end)), s = a.nearest_parameter(b.centre(end));
      if (t > 0 && t < 1) add_end({end, t});
      if (s > 0 && s < 1) add_end({s, end});
    }
  // The nearest balls, unless an end is as near.
  if (!(min_end < least + kMiddleGain)) points.push_back(nearest);
  return least;
}

namespace {

/// Part of an axis, in [0, 1].
struct AxisRange {
  double from = 0, to = 1;

  /// Intersects it with  low <= x + t dx <= high.
  void keep(double x, double dx, double low, double high) {
    if (dx == 0) return;
    const double one = (low - x) / dx, other = (high - x) / dx;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
};

/// Returns the part of A's axis that is above the same face of B as its ball at `t`.
AxisRange over_same_face(const BallHull& a, const CollisionPart& b, double t) {
  AxisRange range;
  const Vector3d p = a.centre(t);
  if (b.form == PartForm::kBox) {
    for (int k = 0; k < 3; ++k)
      if (std::abs(p(k)) < b.half(k) + kFaceTolerance)
        range.keep(a.p0(k), a.axis(k), -b.half(k), b.half(k));
  } else if (b.form == PartForm::kCylinder) {
    // Above the side between the caps, above a cap within the rim.
    if (std::abs(p.z()) < b.half.z() + kFaceTolerance)
      range.keep(a.p0.z(), a.axis.z(), -b.half.z(), b.half.z());
    const double aa = a.axis.head<2>().squaredNorm(), radius = b.half.x();
    if (p.head<2>().norm() < radius + kFaceTolerance && aa > 0) {
      const double half = a.p0.head<2>().dot(a.axis.head<2>()) / aa;
      const double inner = (a.p0.head<2>().squaredNorm() - radius * radius) / aa;
      const double root = std::sqrt(std::max(0.0, half * half - inner));
      range.keep(half, 1, -root, root);
    }
  } else {
    range = {t, t};  // curved everywhere: only the nearest point
  }
  return range;
}

/// Computes the contact of A's ball at t.
ManifoldPoint ball_contact(const BallHull& a, const Shape& b, double t, int feature) {
  ManifoldPoint point = ball_on_shape(a, b, t);
  point.feature = feature_key(FeatureKind::kBalls, feature, 0);
  return point;
}

/// Finds the parameter of the ball of A nearest to B; the gap is convex along the axis.
double nearest_ball(const BallHull& a, const Shape& b) {
  if (a.length == 0) return 0;
  const auto tangent = [&](double t) {
    const NearestSurface seen = b.nearest(a.centre(t));
    return Tangent{t, seen.distance - a.radius(t), seen.normal.dot(a.axis) - a.radius_increase};
  };
  return minimum_position(tangent, 1e-12);
}

}  // namespace

double round_on_convex(const CollisionPart& part_a, const CollisionPart& part_b,
                       const Pose<double>& X_BA, double margin, PartMemory& memory,
                       std::vector<ManifoldPoint>& points) {
  const BallHull a(part_a, X_BA);
  const Shape& b = *part_b.shape;
  const double t = nearest_ball(a, b);
  const ManifoldPoint nearest = ball_contact(a, b, t, kBetween);
  memory.n = nearest.normal;
  memory.overlapped = nearest.gap < 0;
  if (nearest.gap > margin) return nearest.gap;

  // The ends of the part of the axis above the same face.
  const AxisRange range = over_same_face(a, part_b, t);
  double min_end = std::numeric_limits<double>::infinity();
  if (range.to > range.from)
    for (const int end : {kEndLower, kEndUpper}) {
      const double at = end == kEndLower ? range.from : range.to;
      const ManifoldPoint point = ball_contact(a, b, at, end);
      if (point.normal.dot(nearest.normal) < kMinEndCosine) continue;
      min_end = std::min(min_end, point.gap);
      if (point.gap <= margin) points.push_back(point);
    }
  if (!(min_end < nearest.gap + kMiddleGain)) points.push_back(nearest);
  return nearest.gap;
}

}  // namespace thenar::internal
