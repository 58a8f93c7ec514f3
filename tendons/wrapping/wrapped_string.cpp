#include "tendons/wrapping/wrapped_string.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// End of the string seen from the centre of a circle of radius r: distance rho, free run f to the
/// tangent point, and the angle alpha between the two.
struct End {
  double rho, f, alpha;
  Vector3d out, on;  // unit: away from the centre; along the circle, away from the other end
};

End end(double r, double rho, const Vector3d& out, const Vector3d& on) {
  // f and alpha come from the same number, so that their rounding cancels in the length.
  const double f = std::sqrt(std::max((rho - r) * (rho + r), 0.0));
  return {rho, f, std::atan2(f, r), out, on};
}

/// Computes d P / d end, the unit tangent: (f out + r on) / rho; shorter than 1 only inside the
/// circle.
Vector3d tangent(const End& e, double r) { return (e.f * e.out + r * e.on) / e.rho; }

/// Computes d^2 P / d end^2 in the plane: n n' / f, n across the tangent. At f = 0 it is infinite,
/// here 1e9/r.
Eigen::Matrix3d bend(const End& e, double r) {
  const Vector3d n = (std::min(r, e.rho) * e.out - e.f * e.on) / e.rho;
  return n * n.transpose() / std::max(e.f, 1e-7 * r);
}

/// Computes the point where the string leaves the circle.
Vector3d touch(const End& e, double r) {
  const double c = std::min(r / e.rho, 1.0);
  return r * (c * e.out - e.f / e.rho * e.on);
}

/// String in a plane through the centre of the circle, with its ends an angle theta apart.
struct Plane {
  End a, b;
  double length, theta;
  bool bent;
};

Plane across(double r, const End& a, const End& b, double theta) {
  const double arc = theta - a.alpha - b.alpha;
  return {a, b, a.f + b.f + r * arc, theta, arc > 0};
}

void set_planar(WrappedString& chord, const Plane& plane, double r) {
  chord.length = plane.length;
  chord.slope << tangent(plane.a, r), tangent(plane.b, r);
  chord.curve.setZero();
  chord.curve.topLeftCorner<3, 3>() = bend(plane.a, r);
  chord.curve.bottomRightCorner<3, 3>() = bend(plane.b, r);
  chord.touch_a = touch(plane.a, r);
  chord.touch_b = touch(plane.b, r);
}

/// Computes the normal of the plane of a, b and the centre; if they are collinear, of the plane
/// that contains `side`.
Vector3d unit_plane_normal(const Vector3d& a, const Vector3d& b, const Vector3d& side) {
  const Vector3d m = a.cross(b);
  if (m.norm() > 1e-14) return m.normalized();
  const Vector3d held = a.cross(side);
  return held.norm() > 1e-14 ? Vector3d(held.normalized()) : Vector3d(a.unitOrthogonal());
}

WrappedString chord_over_sphere(double r, const Vector3d& a, const Vector3d& b,
                                const Vector3d& side) {
  // Wrap a great circle in the plane of both ends and the centre.
  WrappedString chord = straight_string(a, b);
  const double rho_a = a.norm(), rho_b = b.norm();
  const Vector3d ea = a / rho_a, eb = b / rho_b, m = unit_plane_normal(ea, eb, side);
  const double sine = m.dot(ea.cross(eb)), theta = std::atan2(sine, ea.dot(eb));
  const Plane plane =
      across(r, end(r, rho_a, ea, ea.cross(m)), end(r, rho_b, eb, m.cross(eb)), theta);
  if (!plane.bent) return chord;
  set_planar(chord, plane, r);
  chord.bent = true;
  // Add the second derivatives out of the plane, where the great circle rotates as a whole.
  const double s = std::max(sine, 1e-12), cot = std::cos(theta) / s;
  const Eigen::Matrix3d mm = m * m.transpose();
  chord.curve.topLeftCorner<3, 3>() += (plane.a.f + r * cot) / (rho_a * rho_a) * mm;
  chord.curve.bottomRightCorner<3, 3>() += (plane.b.f + r * cot) / (rho_b * rho_b) * mm;
  chord.curve.topRightCorner<3, 3>() -= r / (rho_a * rho_b * s) * mm;
  chord.curve.bottomLeftCorner<3, 3>() -= r / (rho_a * rho_b * s) * mm;
  return chord;
}

WrappedString chord_over_cylinder(double r, const Vector3d& a, const Vector3d& b,
                                  const Vector3d& side) {
  // Wrap the circle in the plane across the axis.
  WrappedString chord = straight_string(a, b);
  const Vector3d pa(a.x(), a.y(), 0), pb(b.x(), b.y(), 0), z = Vector3d::UnitZ();
  const double rho_a = pa.norm(), rho_b = pb.norm();
  // Count the angle over the side.
  const double turn = angle_from(side, pb) - angle_from(side, pa), way = turn < 0 ? -1 : 1;
  const Vector3d ea = pa / rho_a, eb = pb / rho_b;
  const Plane plane = across(r, end(r, rho_a, ea, -way * z.cross(ea)),
                             end(r, rho_b, eb, way * z.cross(eb)), std::abs(turn));
  if (!plane.bent) return chord;
  set_planar(chord, plane, r);
  chord.bent = true;
  // Add the climb along the axis: unrolled, L^2 = P^2 + dz^2.
  const double P = plane.length, dz = a.z() - b.z(), L = std::hypot(P, dz);
  Eigen::Matrix<double, 6, 1> gz;
  gz << z, -z;
  const Eigen::Matrix<double, 6, 1> turned = dz * chord.slope - P * gz;
  chord.curve = P / L * chord.curve + turned * turned.transpose() / (L * L * L);
  chord.slope = (P * chord.slope + dz * gz) / L;
  chord.length = L;
  chord.touch_a.z() = a.z() - dz * plane.a.f / P;
  chord.touch_b.z() = b.z() + dz * plane.b.f / P;
  return chord;
}

/// End projected out of the surface: an end inside counts as lying on it, at the nearest point.
struct ProjectedEnd {
  Vector3d p;
  bool inside;
  Eigen::Matrix3d J;  // d p / d end, symmetric
};

ProjectedEnd project_out(double r, bool sphere, const Vector3d& end) {
  const Eigen::Vector3d flat(1, 1, sphere ? 1 : 0);
  const Vector3d from = flat.cwiseProduct(end);
  const double rho = from.norm();
  // Keep a point outside, or on the surface to rounding.
  if (rho >= r * (1 - 1e-9)) return {end, false, Eigen::Matrix3d::Identity()};
  // Otherwise take the nearest point, with its derivative by the end.
  const Vector3d n = rho > 0 ? Vector3d(from / rho) : Vector3d::UnitX();
  Eigen::Matrix3d J =
      r / std::max(rho, 1e-6 * r) * (Eigen::Matrix3d(flat.asDiagonal()) - n * n.transpose());
  J(2, 2) += sphere ? 0 : 1;
  return {end + (r - rho) * n, true, J};
}

}  // namespace

double angle_from(const Vector3d& side, const Vector3d& p) {
  return std::atan2(side.x() * p.y() - side.y() * p.x(), side.x() * p.x() + side.y() * p.y());
}

WrappedString straight_string(const Vector3d& a, const Vector3d& b) {
  // Set gradient and Hessian of the distance between the ends.
  WrappedString chord{(a - b).norm(), false, true, {}, {}, a, b};
  chord.slope.setZero();
  chord.curve.setZero();
  if (chord.length == 0) return chord;
  const Vector3d u = (a - b) / chord.length;
  const Eigen::Matrix3d H = (Eigen::Matrix3d::Identity() - u * u.transpose()) / chord.length;
  chord.slope << u, -u;
  chord.curve << H, -H, -H, H;
  return chord;
}

WrappedString wrap_string(const BoneSurface& surface, const Vector3d& a_S, const Vector3d& b_S,
                          const Vector3d& side_S) {
  const bool sphere = surface.shape == SurfaceShape::kSphere;
  require(sphere || surface.shape == SurfaceShape::kCylinder,
          "a chord bends over a sphere or a cylinder, not {}", surface.name);
  // Project ends that lie inside the surface onto it.
  const double r = surface.size[0];
  const ProjectedEnd a = project_out(r, sphere, a_S), b = project_out(r, sphere, b_S);
  WrappedString chord =
      sphere ? chord_over_sphere(r, a.p, b.p, side_S) : chord_over_cylinder(r, a.p, b.p, side_S);
  if (!a.inside && !b.inside) return chord;
  // Apply the chain rule through the projected ends.
  chord.possible = false;
  Eigen::Matrix<double, 6, 6> J = Eigen::Matrix<double, 6, 6>::Zero();
  J << a.J, Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(), b.J;
  chord.slope = J * chord.slope.eval();
  chord.curve = J * chord.curve.eval() * J;
  return chord;
}

}  // namespace thenar
