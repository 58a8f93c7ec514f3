#include "geometry/manifold/first_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Returns a bound of the distance of a body's points from its origin [m].
double radius_about_origin(const CollisionBody& body) { return body.ball.c.norm() + body.ball.r; }

bool is_convex(const CollisionBody& body) {
  return body.parts.size() == 1 && body.parts.front().form != PartForm::kPolyhedron;
}

/// Lower bound of the distance of two bodies, and its direction.
struct Separation {
  double distance = std::numeric_limits<double>::infinity();  // [m]
  Vector3d n{0, 0, 0};  // direction of the nearest points, if they are known (3)
};

Separation separation_of(const CollisionPair& pair) {
  Separation apart;
  apart.distance = pair.distance_bound();
  for (const ManifoldPoint& point : pair.manifold())
    if (point.gap <= apart.distance) apart.distance = point.gap, apart.n = point.normal;
  return apart;
}

}  // namespace

Pose<double> BodyMotion::pose_at(double t) const {
  const double rate = omega.norm(), angle = rate * t;
  Pose<double> X = X_WB;
  X.p += t * v;
  if (angle != 0) X.R = rotation_about<double>(omega / rate, angle) * X_WB.R;
  return X;
}

FirstContact first_contact(CollisionPair& pair, const BodyMotion& a, const BodyMotion& b,
                           double duration, const FirstContactOptions& options) {
  require(a.v.allFinite() && a.omega.allFinite() && b.v.allFinite() && b.omega.allFinite(),
          "velocities must be finite, got {} and {} m/s", a.v.norm(), b.v.norm());
  require(duration >= 0 && std::isfinite(duration), "a duration must be finite and >= 0, got {} s",
          duration);
  require(options.gap > 0, "the gap of a contact must be positive, got {} m", options.gap);
  // Bound the speed at which the bodies approach.
  const double turning = a.omega.norm() * radius_about_origin(pair.a()) +
                         b.omega.norm() * radius_about_origin(pair.b());
  const Vector3d velocity = a.v - b.v;
  const double speed = velocity.norm() + turning;
  const bool convex = is_convex(pair.a()) && is_convex(pair.b());
  // For convex bodies nearest points improve the bound, so the margin covers the whole motion.
  const double margin = std::max(2 * options.gap, convex ? speed * duration : 1e-3);

  FirstContact found;
  for (; found.steps < options.max_steps; ++found.steps) {
    pair.update(a.pose_at(found.time), b.pose_at(found.time), margin);
    const Separation apart = separation_of(pair);
    if (apart.distance <= options.gap) {
      found.found = found.complete = true;
      return found;
    }
    // Advance as far as the bodies can approach until the gap is half of the tolerance.
    const bool directed = convex && !apart.n.isZero(0);
    const double closing = directed ? -apart.n.dot(velocity) + turning : speed;
    const double step = closing > 0 ? (apart.distance - options.gap / 2) / closing
                                    : std::numeric_limits<double>::infinity();
    if (found.time + step >= duration) {
      found.time = duration;
      found.complete = true;
      return found;
    }
    found.time += step;
  }
  return found;
}

Eigen::AlignedBox3d swept_box(const CollisionBody& body, const BodyMotion& motion, double duration,
                              double margin) {
  const double growth =
      motion.omega.squaredNorm() * radius_about_origin(body) * duration * duration / 8 + margin;
  return world_box(body, motion.X_WB, growth)
      .merged(world_box(body, motion.pose_at(duration), growth));
}

}  // namespace thenar
