#include "tendons/wrapping/bone_surface.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Probes a surface at the distance `radius` from a point, or from a line if `across` lacks its
/// direction.
SurfaceProbe round(const Vector3d& from, double radius, const Matrix3d& across) {
  const double distance = from.norm();
  if (distance == 0) return {-radius, across.col(0).normalized(), Matrix3d::Zero()};
  const Vector3d n = from / distance;
  return {distance - radius, n, (across - n * n.transpose()) / distance};
}

SurfaceProbe cylinder(double radius, const Vector3d& p) {
  return round({p.x(), p.y(), 0}, radius, Vector3d(1, 1, 0).asDiagonal());
}

SurfaceProbe capsule(const Vector3d& size, const Vector3d& p) {
  if (std::abs(p.z()) <= size[1]) return cylinder(size[0], p);
  return round(p - Vector3d(0, 0, std::copysign(size[1], p.z())), size[0], Matrix3d::Identity());
}

/// Probes a torus: a circle in the half plane through p and the axis, rotated about z.
SurfaceProbe torus(const Vector3d& size, const Vector3d& p) {
  // Find the nearest point of the ring.
  const double m = std::hypot(p.x(), p.y());
  const Vector3d out = m > 0 ? Vector3d(p.x() / m, p.y() / m, 0) : Vector3d::UnitX();
  const Vector3d round_z = Vector3d::UnitZ().cross(out);
  const Matrix3d plane = Matrix3d::Identity() - round_z * round_z.transpose();
  // Probe the circle of the tube, and add the rotation of the normal about the axis.
  SurfaceProbe probe = round(p - size[1] * out, size[0], plane);
  if (m > 0) probe.curvature += probe.normal.dot(out) / m * round_z * round_z.transpose();
  return probe;
}

/// Computes the nearest point s^2 p / (s^2 + t) of an ellipsoid of semi-axes s; t solves |s p /
/// (s^2 + t)| = 1 and is the only root above -min(s^2). The search is for u = t + min(s^2), which
/// keeps its digits near 0. In the middle of the plane across the shortest axis there is no such
/// root: u = 0, and the point lies off that plane. Source: [Eberly2013].
Vector3d nearest_on_ellipsoid(const Vector3d& s, const Vector3d& p) {
  // Measure the coefficients from the shortest axis.
  Eigen::Index shortest = 0;
  const double least = s.minCoeff(&shortest);
  const Eigen::Array3d s2 = s.array().square(), sp = s.array() * p.array();
  const Eigen::Array3d longer = s2 - least * least;
  // Handle the plane across the shortest axis, where the root may be u = 0.
  if (p[shortest] == 0) {
    Vector3d y = (p.array() == 0).select(0, s2 * p.array() / longer);
    const double rest = 1 - y.cwiseQuotient(s).squaredNorm();
    y[shortest] = least * std::sqrt(std::max(rest, 0.0));
    if (rest >= 0) return y;
  }
  // Bisect between bounds of the root.
  double low = 0, high = sp.matrix().norm() + least * least;
  for (int i = 0; i < 1100 && low < high; ++i) {  // ends at adjacent floating-point numbers
    const double u = 0.5 * (low + high);
    if (u == low || u == high) break;
    ((sp / (longer + u)).matrix().norm() > 1 ? low : high) = u;
  }
  return (s2 * p.array() / (longer + high)).matrix();
}

SurfaceProbe ellipsoid(const Vector3d& s, const Vector3d& p) {
  // Compute normal and shape operator at the nearest point.
  const Vector3d y = nearest_on_ellipsoid(s, p), w = s.array().square().inverse();
  const Vector3d gradient = w.cwiseProduct(y), n = gradient.normalized();
  const double gap = n.dot(p - y);
  const Matrix3d P = Matrix3d::Identity() - n * n.transpose();
  const Matrix3d S = P * w.asDiagonal() * P / gradient.norm();  // shape operator at y
  // Return the curvature of the parallel surface through p.
  return {gap, n, (Matrix3d::Identity() + gap * S).fullPivLu().solve(S)};
}

}  // namespace

SurfaceProbe probe(const BoneSurface& surface, const Vector3d& p_S) {
  switch (surface.shape) {
    case SurfaceShape::kCylinder:
      return cylinder(surface.size[0], p_S);
    case SurfaceShape::kSphere:
      return round(p_S, surface.size[0], Matrix3d::Identity());
    case SurfaceShape::kEllipsoid:
      return ellipsoid(surface.size, p_S);
    case SurfaceShape::kCapsule:
      return capsule(surface.size, p_S);
    case SurfaceShape::kTorus:
      return torus(surface.size, p_S);
  }
  throw InputError("unknown surface shape");
}

Vector3d nearest_point(const BoneSurface& surface, const Vector3d& p_S) {
  const SurfaceProbe at = probe(surface, p_S);
  return p_S - at.gap * at.normal;
}

}  // namespace thenar
