#include "geometry/manifold/curved_contact.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/collision/segment_bounds.h"

namespace thenar::internal {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr double kSectorAngle = kPi / 3;  // Angle between points of a rim [rad]
constexpr double kUprightLean = 1e-4;     // Points of a rim are fixed up to this lean [rad]
constexpr double kLowestLean = 1e-3;   // One point is the lowest of a rim from this lean on [rad]
constexpr double kDepthError = 1e-12;  // Tolerance of a depth along an edge [m]
// Another face replaces the present one if it is better by this [m]
constexpr double kKeepFace = 1e-5;

/// Face of the box that separates best: the face above which the cylinder is highest.
struct FaceAbove {
  int axis = 0;
  double gap = -std::numeric_limits<double>::infinity();  // [m]
};

FaceAbove face_above(const Vector3d& c, const Vector3d& u, const Vector3d& half_a,
                     const Vector3d& half_b, const PartMemory& memory) {
  FaceAbove best;
  const auto gap = [&](int k) {
    const double reach =
        half_a.z() * std::abs(u(k)) + half_a.x() * std::sqrt(std::max(0.0, 1 - u(k) * u(k)));
    return std::abs(c(k)) - half_b(k) - reach;
  };
  for (int k = 0; k < 3; ++k)
    if (gap(k) > best.gap) best = {k, gap(k)};
  // Overlapping bodies keep to their face.
  if (best.gap < 0 && memory.overlapped && memory.axis >= 0 && memory.axis != best.axis &&
      gap(memory.axis) > best.gap - kKeepFace + 0.02 * best.gap)
    best = {memory.axis, gap(memory.axis)};
  return best;
}

/// Returns the largest angle by which the second point of a rim may lag behind its lowest point
/// [rad].
double lag_of(double lean) {
  const double share = (kLowestLean - lean) / (kLowestLean - kUprightLean);
  return kSectorAngle / 2 * std::clamp(share, 0.0, 1.0);
}

}  // namespace

std::optional<double> cylinder_on_face(const CollisionPart& a, const CollisionPart& b,
                                       const Pose<double>& X_BA, double margin, PartMemory& memory,
                                       std::vector<ManifoldPoint>& points) {
  const Vector3d u = X_BA.R.col(2), c = X_BA.p;
  const FaceAbove face = face_above(c, u, a.half, b.half, memory);
  if (face.gap > margin) return face.gap;
  const Vector3d n = (c(face.axis) < 0 ? -1 : 1) * Vector3d::Unit(face.axis);
  // The lowest direction of both rims, as the cylinder sees it.
  const Vector3d low = -(X_BA.R.transpose() * n);
  const double lean = low.head<2>().norm();
  const double lowest = std::atan2(low.y(), low.x());
  const std::size_t first = points.size();
  for (const int cap : {0, 1}) {
    // One of the points follows the lowest one.
    double& phase = memory.phase[cap];
    const double behind = std::remainder(lowest - phase, kSectorAngle), lag = lag_of(lean);
    if (lean > kUprightLean && std::abs(behind) > lag) phase += behind - std::copysign(lag, behind);
    for (int k = 0; k < 6; ++k) {
      const double angle = phase + kSectorAngle * k;
      const Vector3d rim(a.half.x() * std::cos(angle), a.half.x() * std::sin(angle),
                         cap == 0 ? -a.half.z() : a.half.z());
      ManifoldPoint point;
      point.on_a = X_BA * rim;
      point.gap = n.dot(point.on_a) - b.half(face.axis);
      if (point.gap > margin) continue;
      point.on_b = point.on_a - point.gap * n;
      point.normal = n;
      point.feature = feature_key(FeatureKind::kVertexA, 6 * cap + k, 0);
      points.push_back(point);
      // All must be over the face.
      for (int i = 0; i < 3; ++i)
        if (i != face.axis && std::abs(point.on_b(i)) > b.half(i)) {
          points.resize(first);
          return std::nullopt;
        }
    }
  }
  memory.axis = face.axis;
  memory.overlapped = face.gap < 0;
  return face.gap;
}

namespace {

/// The ellipsoid's point lowest along n, and B seen from there.
struct LowestPoint {
  Vector3d p;  // in B's frame [m] (3)
  NearestSurface seen;
};

class EllipsoidSearch {
 public:
  EllipsoidSearch(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA)
      : half_(a.half), b_(*b.shape), X_BA_(X_BA) {}

  [[nodiscard]] LowestPoint at(const Vector3d& n) const {
    const Vector3d e = half_.cwiseProduct(X_BA_.R.transpose() * n);
    const Vector3d p = X_BA_ * Vector3d(-half_.cwiseProduct(e) / e.norm());
    return {p, b_.nearest(p)};
  }

  /// Finds from a guess n the ellipsoid's point at which B's normal equals the direction n along
  /// which the point is lowest.
  [[nodiscard]] std::optional<LowestPoint> find(Vector3d n) const {
    LowestPoint here = at(n);
    double residual = (here.seen.normal - n).norm();
    for (int i = 0; i < 40; ++i) {
      if (residual < kDirectionError) return here;
      const Vector3d to = newton(n, here);
      // Shorter steps while it gets worse.
      Vector3d step = to - n;
      bool better = false;
      for (int k = 0; k < 6 && !better; ++k, step /= 2) {
        const Vector3d tried = (n + step).normalized();
        const LowestPoint there = at(tried);
        const double left = (there.seen.normal - tried).norm();
        better = left < residual;
        if (better) n = tried, here = there, residual = left;
      }
      if (better) continue;
      // Half of the way to what is seen: it always leads down, if slowly.
      const Vector3d middle = n + here.seen.normal;
      if (middle.norm() < 1e-6) return std::nullopt;
      n = middle.normalized();
      here = at(n);
      residual = (here.seen.normal - n).norm();
    }
    return std::nullopt;
  }

 private:
  static constexpr double kDirectionError = 1e-9;  // Tolerance of a direction [1]

  /// A step of Newton's method in the plane across n, by differences.
  [[nodiscard]] Vector3d newton(const Vector3d& n, const LowestPoint& here) const {
    constexpr double kTurnStep = 1e-6;  // Step of the differences of a direction [1]
    const Tangents across = tangents(n);
    Eigen::Matrix<double, 3, 2> T;
    T << across.e1, across.e2;
    const Vector2d f = T.transpose() * (here.seen.normal - n);
    Eigen::Matrix2d slope;
    for (int k = 0; k < 2; ++k) {
      const Vector3d beside = (n + kTurnStep * T.col(k)).normalized();
      slope.col(k) = (T.transpose() * (at(beside).seen.normal - beside) - f) / kTurnStep;
    }
    const double det = slope.determinant();
    if (!(std::abs(det) > 1e-12)) return here.seen.normal;
    const Vector2d step = -(slope.inverse() * f);
    if (!(step.norm() < 0.5)) return here.seen.normal;
    return n + T * step;
  }

  Vector3d half_;
  const Shape& b_;
  Pose<double> X_BA_;
};

/// The point of a box's edges deepest in an ellipsoid. @return its distance, negative [m]
double add_deepest_edge(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                        PartMemory& memory, std::vector<ManifoldPoint>& points) {
  const Pose<double> X_AB = X_BA.inverse();
  NearestSurface best{std::numeric_limits<double>::infinity(), {0, 0, 1}};
  ManifoldPoint point;
  for (int edge = 0; edge < 12; ++edge) {
    // Its direction, and which of the sides beside it.
    const int k = edge / 4, u = (k + 1) % 3, v = (k + 2) % 3;
    Vector3d from = -b.half;
    if (edge & 1) from(u) = b.half(u);
    if (edge & 2) from(v) = b.half(v);
    const Vector3d from_A = X_AB * from, way_A = 2 * b.half(k) * X_AB.R.col(k);
    const double t = least_place(
        [&](double at) {
          const NearestSurface seen = a.shape->nearest(from_A + at * way_A);
          return Tangent{at, seen.distance, seen.normal.dot(way_A)};
        },
        kDepthError);
    const NearestSurface seen = a.shape->nearest(from_A + t * way_A);
    if (seen.distance >= best.distance) continue;
    best = seen;
    point.on_b = from + 2 * t * b.half(k) * Vector3d::Unit(k);
    point.feature = feature_key(FeatureKind::kEdges, 0, edge);
  }
  point.normal = -(X_BA.R * best.normal);
  point.gap = best.distance;
  point.on_a = point.on_b + best.distance * point.normal;
  memory.n = point.normal;
  memory.overlapped = true;
  points.push_back(point);
  return best.distance;
}

}  // namespace

std::optional<double> ellipsoid_on_convex(const CollisionPart& a, const CollisionPart& b,
                                          const Pose<double>& X_BA, double margin,
                                          PartMemory& memory, std::vector<ManifoldPoint>& points) {
  // From the last normal; else from the nearest surface of B.
  const EllipsoidSearch search(a, b, X_BA);
  std::optional<LowestPoint> found;
  if (!memory.n.isZero(0)) found = search.find(memory.n);
  if (!found) found = search.find(b.shape->nearest(X_BA.p).normal);
  if (!found && b.form == PartForm::kBox) return add_deepest_edge(a, b, X_BA, memory, points);
  if (!found) {
    memory.n.setZero();
    return std::nullopt;
  }
  const double bound = found->seen.distance;
  memory.n = found->seen.normal;
  memory.overlapped = bound < 0;
  if (bound > margin) return bound;
  ManifoldPoint point;
  point.on_a = found->p;
  point.on_b = found->p - found->seen.distance * found->seen.normal;
  point.normal = found->seen.normal;
  point.gap = found->seen.distance;
  point.feature = feature_key(FeatureKind::kWitness, 1, 0);
  points.push_back(point);
  return bound;
}

}  // namespace thenar::internal
