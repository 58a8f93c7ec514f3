#include "geometry/manifold/curved_contact.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/collision/segment_bounds.h"

namespace thenar::internal {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr double kSectorAngle = kPi / 3;   // angle between points of a rim [rad]
constexpr double kFixedPointLean = 1e-4;   // lean up to which points of a rim are fixed [rad]
constexpr double kLowestPointLean = 1e-3;  // lean from which one point is the lowest [rad]
constexpr double kDepthTolerance = 1e-12;  // tolerance of a depth along an edge [m]
// Depth by which another face must be better than the last: absolute [m], relative [1]
constexpr double kKeepFaceDepth = 1e-5, kKeepFaceRatio = 0.02;

/// Face of the box above which the cylinder is highest, which separates best.
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
  // Keep the last face of overlapping bodies, unless another is clearly better.
  if (best.gap < 0 && memory.overlapped && memory.axis >= 0 && memory.axis != best.axis &&
      gap(memory.axis) > best.gap - kKeepFaceDepth + kKeepFaceRatio * best.gap)
    best = {memory.axis, gap(memory.axis)};
  return best;
}

/// Returns the maximum angle by which the nearest point of a rim may lag behind its lowest point
/// [rad].
double max_lag(double lean) {
  const double share = (kLowestPointLean - lean) / (kLowestPointLean - kFixedPointLean);
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
  // Compute the lowest direction of both rims, in the cylinder's frame.
  const Vector3d low = -(X_BA.R.transpose() * n);
  const double lean = low.head<2>().norm();
  const double lowest = std::atan2(low.y(), low.x());
  const std::size_t first = points.size();
  for (const int cap : {0, 1}) {
    // Rotate the points so that one follows the lowest direction.
    double& phase = memory.phase[cap];
    const double behind = std::remainder(lowest - phase, kSectorAngle), lag = max_lag(lean);
    if (lean > kFixedPointLean && std::abs(behind) > lag)
      phase += behind - std::copysign(lag, behind);
    for (int k = 0; k < 6; ++k) {
      const double angle = phase + kSectorAngle * k;
      const Vector3d rim(a.half.x() * std::cos(angle), a.half.x() * std::sin(angle),
                         cap == 0 ? -a.half.z() : a.half.z());
      const Vector3d on_a = X_BA * rim;
      const double gap = n.dot(on_a) - b.half(face.axis);
      if (gap > margin) continue;
      const Vector3d on_b = on_a - gap * n;
      points.push_back({on_a, on_b, n, gap, feature_key(FeatureKind::kVertexA, 6 * cap + k, 0)});
      // Require that all points are above the face.
      for (int i = 0; i < 3; ++i)
        if (i != face.axis && std::abs(on_b(i)) > b.half(i)) {
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

/// The ellipsoid's lowest point along n, with the surface of B nearest to it.
struct LowestPoint {
  Vector3d p;  // in B's frame [m] (3)
  NearestSurface seen;
};

/// Search for the point of an ellipsoid deepest in, or nearest to, a convex solid.
class EllipsoidSearch {
 public:
  EllipsoidSearch(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA)
      : half_(a.half), b_(*b.shape), X_BA_(X_BA) {}

  [[nodiscard]] LowestPoint lowest_point(const Vector3d& n) const {
    const Vector3d e = half_.cwiseProduct(X_BA_.R.transpose() * n);
    const Vector3d p = X_BA_ * Vector3d(-half_.cwiseProduct(e) / e.norm());
    return {p, b_.nearest(p)};
  }

  /// Finds, from a guess n, the ellipsoid's lowest point along a direction that equals B's normal
  /// there.
  [[nodiscard]] std::optional<LowestPoint> find_deepest(Vector3d n) const {
    LowestPoint here = lowest_point(n);
    double residual = (here.seen.normal - n).norm();
    for (int i = 0; i < kMaxSteps; ++i) {
      if (residual < kDirectionError) return here;
      const Vector3d to = newton(n, here);
      // Halve the Newton step while the residual grows.
      Vector3d step = to - n;
      bool better = false;
      for (int k = 0; k < kMaxHalvings && !better; ++k, step /= 2) {
        const Vector3d tried = (n + step).normalized();
        const LowestPoint there = lowest_point(tried);
        const double new_residual = (there.seen.normal - tried).norm();
        better = new_residual < residual;
        if (better) n = tried, here = there, residual = new_residual;
      }
      if (better) continue;
      // Otherwise move halfway to B's normal, which always descends, though slowly.
      const Vector3d middle = n + here.seen.normal;
      if (middle.norm() < kOppositeNormals) return std::nullopt;
      n = middle.normalized();
      here = lowest_point(n);
      residual = (here.seen.normal - n).norm();
    }
    return std::nullopt;
  }

 private:
  static constexpr double kDirectionError = 1e-9;   // tolerance of a direction [1]
  static constexpr int kMaxSteps = 40;              // maximum number of steps
  static constexpr int kMaxHalvings = 6;            // maximum number of halvings of a step
  static constexpr double kOppositeNormals = 1e-6;  // norm of their sum that has no direction [1]
  static constexpr double kSingularSlope = 1e-12;   // determinant of a singular slope [1]
  static constexpr double kMaxNewtonStep = 0.5;     // step above which Newton's method fails [1]

  /// Returns the direction after a Newton step in the plane perpendicular to n, with finite
  /// differences.
  [[nodiscard]] Vector3d newton(const Vector3d& n, const LowestPoint& here) const {
    constexpr double kTurnStep = 1e-6;  // finite-difference step of a direction [1]
    const Eigen::Matrix<double, 3, 2> T = basis_along(n).leftCols<2>();
    const Vector2d f = T.transpose() * (here.seen.normal - n);
    Eigen::Matrix2d slope;
    for (int k = 0; k < 2; ++k) {
      const Vector3d beside = (n + kTurnStep * T.col(k)).normalized();
      slope.col(k) = (T.transpose() * (lowest_point(beside).seen.normal - beside) - f) / kTurnStep;
    }
    const double det = slope.determinant();
    if (!(std::abs(det) > kSingularSlope)) return here.seen.normal;
    const Vector2d step = -(slope.inverse() * f);
    if (!(step.norm() < kMaxNewtonStep)) return here.seen.normal;
    return n + T * step;
  }

  Vector3d half_;
  const Shape& b_;
  Pose<double> X_BA_;
};

/// Adds the point of a box's edges deepest in an ellipsoid. @return its distance, negative [m]
double add_deepest_edge(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                        PartMemory& memory, std::vector<ManifoldPoint>& points) {
  const Pose<double> X_AB = X_BA.inverse();
  NearestSurface best{std::numeric_limits<double>::infinity(), {0, 0, 1}};
  ManifoldPoint point;
  for (int edge = 0; edge < 12; ++edge) {
    // Find the direction of the edge, and the signs of its position.
    const int k = edge / 4, u = (k + 1) % 3, v = (k + 2) % 3;
    Vector3d from = -b.half;
    if (edge & 1) from(u) = b.half(u);
    if (edge & 2) from(v) = b.half(v);
    const Vector3d from_A = X_AB * from, edge_A = 2 * b.half(k) * X_AB.R.col(k);
    const double t = minimum_position(
        [&](double at) {
          const NearestSurface seen = a.shape->nearest(from_A + at * edge_A);
          return Tangent{at, seen.distance, seen.normal.dot(edge_A)};
        },
        kDepthTolerance);
    const NearestSurface seen = a.shape->nearest(from_A + t * edge_A);
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
  // Start from the last normal, otherwise from the nearest surface of B.
  const EllipsoidSearch search(a, b, X_BA);
  std::optional<LowestPoint> found;
  if (!memory.n.isZero(0)) found = search.find_deepest(memory.n);
  if (!found) found = search.find_deepest(b.shape->nearest(X_BA.p).normal);
  if (!found && b.form == PartForm::kBox) return add_deepest_edge(a, b, X_BA, memory, points);
  if (!found) {
    memory.n.setZero();
    return std::nullopt;
  }
  const double bound = found->seen.distance;
  memory.n = found->seen.normal;
  memory.overlapped = bound < 0;
  if (bound > margin) return bound;
  points.push_back({found->p, found->p - bound * memory.n, memory.n, bound,
                    feature_key(FeatureKind::kWitness, 1, 0)});
  return bound;
}

}  // namespace thenar::internal
