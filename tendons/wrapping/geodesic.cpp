#include "tendons/wrapping/geodesic.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Transports the Jacobi fields over a length s of constant curvature K = k^2.
void carry_fields(GeodesicEnd& end, double k, double s) {
  const double c = k > 0 ? std::cos(k * s) : 1, f = k > 0 ? std::sin(k * s) / k : s;
  const GeodesicEnd was = end;
  end.a = c * was.a + f * was.da;
  end.da = c * was.da - k * k * f * was.a;
  end.r = c * was.r + f * was.dr;
  end.dr = c * was.dr - k * k * f * was.r;
}

/// Follows a great circle about `center`.
void along_sphere(GeodesicEnd& end, const Vector3d& center, double radius, double s) {
  const Vector3d n = (end.ray.p - center) / radius, t = end.ray.t;
  const double c = std::cos(s / radius), f = std::sin(s / radius);
  end.ray = {center + radius * (c * n + f * t), c * t - f * n};
  carry_fields(end, 1 / radius, s);
}

/// Follows a helix about z.
void along_cylinder(GeodesicEnd& end, double radius, double s) {
  // Compute the normal, the direction round the axis and the angle of rotation.
  const Vector3d n(end.ray.p.x() / radius, end.ray.p.y() / radius, 0), t = end.ray.t;
  const Vector3d round = Vector3d::UnitZ().cross(n);
  const double across = t.dot(round), angle = s * across / radius;
  const double c = std::cos(angle), f = std::sin(angle);
  // Set the new position and direction.
  const Vector3d out = c * n + f * round;
  end.ray.p = radius * out + Vector3d(0, 0, end.ray.p.z() + s * t.z());
  end.ray.t = across * Vector3d::UnitZ().cross(out) + Vector3d(0, 0, t.z());
  carry_fields(end, 0, s);
}

/// Computes the angle along a great circle from p until its height z about `center` is zero, in the
/// direction of s: the first root ahead of  n_z cos(u) + t_z sin(u) = 0.
double to_equator(const Vector3d& n, const Vector3d& t, double sign) {
  double u = std::atan2(-n.z(), t.z());  // a root; the others are pi apart
  while (sign * u <= 1e-12) u += sign * std::acos(-1.0);
  while (sign * u > std::acos(-1.0) + 1e-12) u -= sign * std::acos(-1.0);
  return u;
}

/// Follows the cylinder of a capsule up to the seam, or to the end. @return remaining length [m]
double along_side(GeodesicEnd& end, const Vector3d& size, double s) {
  const double radius = size[0], half = size[1];
  const double sign = s > 0 ? 1 : -1, climb = sign * end.ray.t.z();
  const double remaining =
      climb == 0 ? std::abs(s) : (std::copysign(half, climb) - end.ray.p.z()) / climb;
  const double step = sign * std::min(std::abs(s), std::max(remaining, 0.0));
  along_cylinder(end, radius, step);
  const double left = step == s ? 0 : s - step;
  if (left != 0) end.ray.p.z() = std::copysign(half, climb);
  return left;
}

/// Follows a cap of a capsule up to its equator, or to the end. @return remaining length [m]
double along_cap(GeodesicEnd& end, const Vector3d& size, double s) {
  const double radius = size[0], half = size[1], sign = s > 0 ? 1 : -1;
  const Vector3d center(0, 0, std::copysign(half, end.ray.p.z()));
  const double remaining =
      radius * std::abs(to_equator((end.ray.p - center) / radius, end.ray.t, sign));
  const double step = sign * std::min(std::abs(s), remaining);
  along_sphere(end, center, radius, step);
  const double left = step == s ? 0 : s - step;
  if (left != 0) end.ray.p.z() = center.z();
  return left;
}

/// Follows cylinder and caps of a capsule in turn; `s` is the remaining length.
void along_capsule(GeodesicEnd& end, const Vector3d& size, double s) {
  const double half = size[1];
  for (int piece = 0; piece < 64 && s != 0; ++piece) {
    // Choose the next piece; on a seam, by the direction.
    const double climb = (s > 0 ? 1 : -1) * end.ray.t.z(), z = end.ray.p.z();
    const bool cap =
        std::abs(z) > half * (1 + 1e-14) || (std::abs(z) >= half * (1 - 1e-14) && z * climb > 0);
    s = cap ? along_cap(end, size, s) : along_side(end, size, s);
  }
}

/// Computes normal and shape operator of an ellipsoid of semi-axes s at a point on it.
SurfaceCurvature ellipsoid_at(const Vector3d& s, const Vector3d& p) {
  const Vector3d w = s.array().square().inverse(), gradient = w.cwiseProduct(p);
  const double size = gradient.norm();
  const Vector3d n = gradient / size;
  const Matrix3d P = Matrix3d::Identity() - n * n.transpose();
  return {n, P * w.asDiagonal() * P / size};
}

/// Computes the Gaussian curvature from the shape operator, whose third eigenvalue is 0.
double gaussian_curvature(const Matrix3d& S) {
  const double trace = S.trace();
  return 0.5 * (trace * trace - S.squaredNorm());
}

/// State of the integration: p, t, and the Jacobi fields with their slopes.
using State = Eigen::Matrix<double, 10, 1>;

State rate(const BoneSurface& surface, const State& y) {
  const SurfaceCurvature at = surface_curvature(surface, y.head<3>());
  const Vector3d t = y.segment<3>(3);
  const double K = gaussian_curvature(at.S);
  State f;
  f << t, -t.dot(at.S * t) * at.n, y[7], -K * y[6], y[9], -K * y[8];
  return f;
}

/// Integrates by the modified midpoint rule, n steps over h. Source: [Hairer1993] section II.9.
State midpoint(const BoneSurface& surface, const State& y0, double h, int n) {
  // Take an Euler step, then midpoint steps.
  const double step = h / n;
  State before = y0, now = y0 + step * rate(surface, y0);
  for (int i = 1; i < n; ++i) {
    const State next = before + 2 * step * rate(surface, now);
    before = now;
    now = next;
  }
  // Smooth the end point.
  return 0.5 * (now + before + step * rate(surface, now));
}

/// Extrapolates the midpoint rule in h^2 until two columns agree; order 2 * columns.
State extrapolate(const BoneSurface& surface, const State& y0, double h) {
  constexpr int kStateColumns = 9;       // largest number of columns of the Aitken-Neville scheme
  std::array<State, kStateColumns> row;  // last row of the scheme
  // Add columns of the Aitken-Neville scheme.
  State best = y0;
  for (int k = 0; k < kStateColumns; ++k) {
    const double n = 2 * (k + 1);
    State newer = midpoint(surface, y0, h, static_cast<int>(n));
    // Eliminate the next even power of the step.
    for (int j = 0; j < k; ++j) {
      const double ratio = n / (2 * (k - j)), grown = ratio * ratio - 1;
      const State better = newer + (newer - row[j]) / grown;
      row[j] = newer;
      newer = better;
    }
    row[k] = newer;
    // Stop when two columns agree.
    const double change = (newer - best).head<6>().norm();
    best = newer;
    if (change < 1e-16) break;
  }
  return best;
}

/// Integrates a geodesic in steps of at most half a radian at the surface's largest curvature.
GeodesicEnd integrate(const BoneSurface& surface, const SurfaceRay& start, double length,
                      double max_curvature) {
  // Take extrapolated steps from the start, with unit Jacobi fields.
  const int steps = std::max(1, static_cast<int>(std::ceil(2 * std::abs(length) * max_curvature)));
  State y;
  y << start.p, start.t, 1, 0, 0, 1;
  for (int i = 0; i < steps; ++i) y = extrapolate(surface, y, length / steps);
  return {{y.head<3>(), y.segment<3>(3).normalized()}, y[6], y[7], y[8], y[9]};
}

}  // namespace

GeodesicEnd follow_geodesic(const BoneSurface& surface, const SurfaceRay& start, double length) {
  const Vector3d& size = surface.size;
  GeodesicEnd end{start};
  switch (surface.shape) {
    case SurfaceShape::kSphere:
      along_sphere(end, Vector3d::Zero(), size[0], length);
      break;
    case SurfaceShape::kCylinder:
      along_cylinder(end, size[0], length);
      break;
    case SurfaceShape::kCapsule:
      along_capsule(end, size, length);
      break;
    case SurfaceShape::kEllipsoid: {
      const double least = size.minCoeff(), most = size.maxCoeff();
      return integrate(surface, start, length, most / (least * least));
    }
    case SurfaceShape::kTorus:
      return integrate(surface, start, length,
                       std::max(1 / size[0], 1 / std::max(size[1] - size[0], 1e-6)));
  }
  return end;
}

SurfaceCurvature surface_curvature(const BoneSurface& surface, const Vector3d& p_S) {
  if (surface.shape == SurfaceShape::kEllipsoid) return ellipsoid_at(surface.size, p_S);
  const SurfaceProbe at = probe(surface, p_S);
  return {at.normal, at.curvature};
}

double level(const BoneSurface& surface, const Vector3d& p_S) {
  if (surface.shape != SurfaceShape::kEllipsoid) return probe(surface, p_S).gap;
  const Vector3d u = p_S.cwiseQuotient(surface.size);
  const double f = 0.5 * (u.squaredNorm() - 1), slope = u.cwiseQuotient(surface.size).norm();
  return slope > 0 ? f / slope : -surface.size.minCoeff();
}

SurfaceRay project_to_surface(const BoneSurface& surface, const SurfaceRay& near) {
  // Move the point onto the surface.
  Vector3d p = near.p;
  if (surface.shape == SurfaceShape::kEllipsoid) {
    p /= p.cwiseQuotient(surface.size).norm();  // along the ray from the centre: exactly on it
  } else {
    const SurfaceProbe at = probe(surface, p);
    p -= at.gap * at.normal;
  }
  // Make the direction a unit tangent.
  const Vector3d n = surface_curvature(surface, p).n;
  return {p, (near.t - near.t.dot(n) * n).normalized()};
}

}  // namespace thenar
