#include "geometry/shape_mass.h"

#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/units.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_parts.h"

namespace thenar {
namespace {

Eigen::Matrix3d diagonal(double x, double y, double z) {
  return Eigen::Vector3d(x, y, z).asDiagonal();
}

MassProperties ellipsoid(const Eigen::Vector3d& s) {
  const double m = 4 * kPi / 3 * s.prod();
  const Eigen::Vector3d q = s.cwiseAbs2();
  return {m, {0, 0, 0}, m / 5 * diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y())};
}

MassProperties box(const Eigen::Vector3d& edges) {
  const double m = edges.prod();
  const Eigen::Vector3d q = edges.cwiseAbs2();
  return {m, {0, 0, 0}, m / 12 * diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y())};
}

MassProperties cylinder(double r, double height) {
  const double m = kPi * r * r * height, across = m * (3 * r * r + height * height) / 12;
  return {m, {0, 0, 0}, diagonal(across, across, m * r * r / 2)};
}

/// A cylinder and two half balls, whose centroids stand 3/8 r from their flat sides.
MassProperties capsule(double r, double height) {
  MassProperties body = cylinder(r, height);
  const double m = 4 * kPi / 3 * r * r * r, h = height / 2;
  const double across = m * (2 * r * r / 5 + h * h + 3 * h * r / 4);
  body.mass += m;
  body.inertia += diagonal(across, across, m * 2 * r * r / 5);
  return body;
}

/// With B the beta function, by Dirichlet's integrals over  x = a cos^e1 cos^e2, y = b cos^e1
/// sin^e2, z = c sin^e1:
///   volume = 2 abc e1 e2 B(e1/2, e1 + 1) B(e2/2, e2/2 + 1),
///   integral of x^2 = 1/2 a^3 bc e1 e2 B(3/2 e2, e2/2) B(e1/2, 2 e1 + 1),  of y^2 alike,
///   integral of z^2 = 2 ab c^3 e1 e2 B(e2/2, e2/2 + 1) B(3/2 e1, e1 + 1).
MassProperties superellipsoid(const Eigen::Vector3d& s, const Eigen::Vector2d& e) {
  const double size = s.prod() * e.prod(), turn = std::beta(e[1] / 2, e[1] / 2 + 1);
  const double across =
      size / 2 * std::beta(1.5 * e[1], e[1] / 2) * std::beta(e[0] / 2, 2 * e[0] + 1);
  const double x = s.x() * s.x() * across, y = s.y() * s.y() * across;
  const double z = 2 * size * s.z() * s.z() * turn * std::beta(1.5 * e[0], e[0] + 1);
  return {
      2 * size * std::beta(e[0] / 2, e[0] + 1) * turn, {0, 0, 0}, diagonal(y + z, x + z, x + y)};
}

/// Triangles that face inwards are turned first: each takes away twice what it holds.
MassProperties enclosed(const TriangleMesh& mesh) {
  if (mesh.empty()) return {};
  const MeshReport found = check_mesh(mesh);
  if (found.watertight() && found.volume > 0) return signed_moments(mesh);
  std::vector<MassProperties> parts;
  try {
    for (const TriangleMesh& part : solid_parts(mesh)) parts.push_back(signed_moments(part));
  } catch (const InputError&) {
    return {};  // it bounds no solid
  }
  return together(parts);
}

MassProperties in_own_frame(const ShapeSpec& shape) {
  const Eigen::Vector3d& s = shape.size;
  switch (shape.kind) {
    case ShapeKind::kSphere:
      return ellipsoid(Eigen::Vector3d::Constant(s.x()));
    case ShapeKind::kBox:
      return box(s);
    case ShapeKind::kCylinder:
      return cylinder(s.x(), s.y());
    case ShapeKind::kCapsule:
      return capsule(s.x(), s.y());
    case ShapeKind::kEllipsoid:
      return ellipsoid(s);
    case ShapeKind::kMesh:
      return enclosed(shape.mesh);
    case ShapeKind::kSuperellipsoid:
      return superellipsoid(s, shape.exponents);
    case ShapeKind::kTaperedCapsule:
      break;
  }
  throw InputError(fmt::format("the mass of a {} has no closed form here", name_of(shape.kind)));
}

}  // namespace

MassProperties mass_at_unit_density(const ShapeSpec& shape) {
  const MassProperties own = in_own_frame(shape);
  const Eigen::Matrix3d& R = shape.X_BS.R;
  return {own.mass, shape.X_BS * own.centre, R * own.inertia * R.transpose()};
}

MassProperties together(const std::vector<MassProperties>& parts) {
  MassProperties sum;
  for (const MassProperties& part : parts) {
    sum.mass += part.mass;
    sum.centre += part.mass * part.centre;
  }
  if (sum.mass > 0) sum.centre /= sum.mass;
  for (const MassProperties& part : parts) {
    const Eigen::Vector3d r = part.centre - sum.centre;
    sum.inertia += part.inertia +
                   part.mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return sum;
}

}  // namespace thenar
