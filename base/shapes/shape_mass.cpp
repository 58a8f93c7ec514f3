#include "base/shapes/shape_mass.h"

#include <fmt/format.h>

#include "base/angles.h"
#include "base/error.h"
#include "base/shapes/mesh_check.h"
#include "base/shapes/mesh_parts.h"

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
    case ShapeKind::kTaperedCapsule:
    case ShapeKind::kSuperellipsoid:
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
