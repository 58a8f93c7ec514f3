#include "geometry/manifold/part_pair.h"

#include <cmath>

#include "geometry/manifold/box_contact.h"
#include "geometry/manifold/polyhedron_contact.h"
#include "geometry/manifold/round_contact.h"

namespace thenar {

using Eigen::Vector3d;

namespace internal {

void flip_points(std::vector<ManifoldPoint>& points, std::size_t first, const Pose<double>& X) {
  for (std::size_t i = first; i < points.size(); ++i) {
    ManifoldPoint& point = points[i];
    const Vector3d on_a = X * point.on_b;
    point.on_b = X * point.on_a;
    point.on_a = on_a;
    point.normal = -(X.R * point.normal);
  }
}

}  // namespace internal

double motion_bound(const Ball& ball, const Pose<double>& from, const Pose<double>& to) {
  // The Frobenius norm of a difference of rotations is sqrt(2) times its 2-norm.
  const Eigen::Matrix3d turn = to.R - from.R;
  return (turn * ball.c + to.p - from.p).norm() + std::sqrt(turn.squaredNorm() / 2) * ball.r;
}

namespace {

/// The points of A on B where B's form comes first.
double find_flipped(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                    double margin, PartMemory& memory, std::vector<ManifoldPoint>& points) {
  const std::size_t first = points.size();
  const double bound = find_points(b, a, X_BA.inverse(), margin, memory, points);
  internal::flip_points(points, first, X_BA);
  return bound;
}

}  // namespace

double find_points(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                   double margin, PartMemory& memory, std::vector<ManifoldPoint>& points) {
  // The lesser form is A.
  if (b.form < a.form) return find_flipped(a, b, X_BA, margin, memory, points);
  if (b.form == PartForm::kRound)
    return internal::round_on_round(a, b, X_BA, margin, memory, points);
  if (a.form == PartForm::kRound && b.form != PartForm::kPolyhedron)
    return internal::round_on_convex(a, b, X_BA, margin, memory, points);
  if (a.form == PartForm::kBox && b.form == PartForm::kBox)
    return internal::box_on_box(a, b, X_BA, margin, memory, points);
  if (a.form == PartForm::kRound)
    return internal::round_on_polyhedron(a, b, X_BA, margin, memory, points);
  return internal::polyhedron_on_polyhedron(a, b, X_BA, margin, memory, points);
}

}  // namespace thenar
