#include "geometry/manifold/part_pair.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/manifold/box_contact.h"
#include "geometry/manifold/curved_contact.h"
#include "geometry/manifold/polyhedron_contact.h"
#include "geometry/manifold/round_contact.h"

namespace thenar {

using Eigen::Vector3d;

namespace internal {

void exchange_bodies(std::vector<ManifoldPoint>& points, std::size_t first, const Pose<double>& X) {
  for (std::size_t i = first; i < points.size(); ++i) {
    ManifoldPoint& point = points[i];
    const Vector3d on_a = X * point.on_b;
    point.on_b = X * point.on_a;
    point.on_a = on_a;
    point.normal = -(X.R * point.normal);
  }
}

}  // namespace internal

double motion_bound(const Ball& a, const Ball& b, const Pose<double>& from_BA,
                    const Pose<double>& to_BA) {
  // The Frobenius norm of a difference of rotations is sqrt(2) times its 2-norm.
  const Eigen::Matrix3d turn = to_BA.R - from_BA.R;
  const double rate = std::sqrt(turn.squaredNorm() / 2);
  const double of_a = (turn * a.c + to_BA.p - from_BA.p).norm() + rate * a.r;
  const Vector3d back =
      to_BA.R.transpose() * (b.c - to_BA.p) - from_BA.R.transpose() * (b.c - from_BA.p);
  return std::min(of_a, back.norm() + rate * b.r);
}

namespace {

/// Finds the points with A and B exchanged, if B's form comes first.
double find_flipped(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                    double margin, PartMemory& memory, std::vector<ManifoldPoint>& points) {
  const std::size_t first = points.size();
  const double bound = find_points(b, a, X_BA.inverse(), margin, memory, points);
  internal::exchange_bodies(points, first, X_BA);
  return bound;
}

/// Finds the points of a box A and a cylinder B: on a face, otherwise as polyhedra.
double cylinder_on_box(const CollisionPart& box, const CollisionPart& cylinder,
                       const Pose<double>& X_BA, double margin, PartMemory& memory,
                       std::vector<ManifoldPoint>& points) {
  const std::size_t first = points.size();
  const std::optional<double> bound =
      internal::cylinder_on_face(cylinder, box, X_BA.inverse(), margin, memory, points);
  internal::exchange_bodies(points, first, X_BA);
  if (bound) return *bound;
  return internal::polyhedron_on_polyhedron(box, cylinder, X_BA, margin, memory, points);
}

/// Finds the points of a convex solid and an ellipsoid, in any order; if that fails, as polyhedra.
double ellipsoid_on_solid(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                          double margin, PartMemory& memory, std::vector<ManifoldPoint>& points) {
  const std::size_t first = points.size();
  const std::optional<double> bound =
      a.is_ellipsoid ? internal::ellipsoid_on_convex(a, b, X_BA, margin, memory, points)
                     : internal::ellipsoid_on_convex(b, a, X_BA.inverse(), margin, memory, points);
  if (!a.is_ellipsoid) internal::exchange_bodies(points, first, X_BA);
  if (bound) return *bound;
  return internal::polyhedron_on_polyhedron(a, b, X_BA, margin, memory, points);
}

}  // namespace

double find_points(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                   double margin, PartMemory& memory, std::vector<ManifoldPoint>& points) {
  // Take as A the part whose form comes first.
  if (b.form < a.form) return find_flipped(a, b, X_BA, margin, memory, points);
  if (b.form == PartForm::kRound)
    return internal::round_on_round(a, b, X_BA, margin, memory, points);
  if (a.form == PartForm::kRound && b.form != PartForm::kPolyhedron)
    return internal::round_on_convex(a, b, X_BA, margin, memory, points);
  if (a.form == PartForm::kBox && b.form == PartForm::kBox)
    return internal::box_on_box(a, b, X_BA, margin, memory, points);
  if (a.form == PartForm::kRound)
    return internal::round_on_polyhedron(a, b, X_BA, margin, memory, points);
  // Handle cylinders and ellipsoids on convex solids; if that fails, treat them as polyhedra.
  if (a.form == PartForm::kBox && b.form == PartForm::kCylinder)
    return cylinder_on_box(a, b, X_BA, margin, memory, points);
  if (b.form != PartForm::kPolyhedron && (a.is_ellipsoid || b.is_ellipsoid))
    return ellipsoid_on_solid(a, b, X_BA, margin, memory, points);
  return internal::polyhedron_on_polyhedron(a, b, X_BA, margin, memory, points);
}

}  // namespace thenar
