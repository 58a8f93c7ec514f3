#include "tendons/wrapping/planar_wrap.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace thenar {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Computes the squared distance of the segment a b from the origin.
double squared_distance(const Vector2d& a, const Vector2d& b) {
  const Vector2d d = b - a;
  const double length2 = d.squaredNorm(), along = -a.dot(d);
  if (along <= 0) return a.squaredNorm();
  if (along >= length2) return b.squaredNorm();
  const double area = cross(a, b);
  return area * area / length2;
}

/// Computes the tangent point from p. @param way  sense in which the string continues from p: 1
/// counterclockwise, -1 clockwise
Vector2d touch(double r, const Vector2d& p, double rho, double free, double way) {
  const double part = r / rho;
  const Vector2d e = part * p, across(-e.y(), e.x());
  return std::min(part, 1.0) * e + way * free / rho * across;
}

}  // namespace

std::optional<PlanarWrap> wrap_circle(double r, const Vector2d& a, const Vector2d& b,
                                      const Vector2d& side) {
  // Test whether the straight line passes on the wrong side, or through the circle.
  const double above_a = cross(side, a), above_b = cross(side, b);
  const bool parted = (above_a > 0) != (above_b > 0);
  // The straight line crosses the line of `side` at (a above_b - b above_a) / (above_b - above_a).
  const bool barred =
      parted && (side.dot(a) * above_b - side.dot(b) * above_a) * (above_b - above_a) < 0;
  if (!barred && squared_distance(a, b) >= r * r) return std::nullopt;

  // Choose the sense of rotation about the origin.
  PlanarWrap wrap;
  wrap.sense = (parted ? above_b > 0 : cross(a, b) > 0) ? 1 : -1;
  const double rho_a = a.norm(), rho_b = b.norm();
  if (std::min(rho_a, rho_b) == 0) return std::nullopt;
  // Compute the straight parts and touch points.
  wrap.free_a = std::sqrt(std::max(rho_a * rho_a - r * r, 0.0));
  wrap.free_b = std::sqrt(std::max(rho_b * rho_b - r * r, 0.0));
  wrap.touch_a = touch(r, a, rho_a, wrap.free_a, wrap.sense);
  wrap.touch_b = touch(r, b, rho_b, wrap.free_b, -wrap.sense);
  // Compute the angle between the touch points, in that sense.
  wrap.angle =
      std::atan2(wrap.sense * cross(wrap.touch_a, wrap.touch_b), wrap.touch_a.dot(wrap.touch_b));
  if (wrap.angle < 0) {
    if (!barred) return std::nullopt;  // negative by rounding only
    wrap.angle += 2 * kPi;
  }
  return wrap;
}

bool crossed_far_side(const Vector2d& side, const Vector2d& was, const Vector2d& is) {
  const bool left_before = cross(side, was) > 0, left_now = cross(side, is) > 0;
  if (left_before == left_now) return false;
  // Test whether the angle from right to left over the side exceeds half a turn.
  return (left_before ? cross(is, was) : cross(was, is)) < 0;
}

}  // namespace thenar
