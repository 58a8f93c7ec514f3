#include "data/io/robot/shape_mass.h"

#include <fmt/format.h>

#include "base/angles.h"
#include "base/error.h"

namespace thenar {
namespace {

Eigen::Matrix3d diagonal(double x, double y, double z) {
  return Eigen::Vector3d(x, y, z).asDiagonal();
}

ShapeMass ellipsoid(const Eigen::Vector3d& s) {
  const double m = 4 * kPi / 3 * s.prod();
  const Eigen::Vector3d q = s.cwiseAbs2();
  return {m, {0, 0, 0}, m / 5 * diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y())};
}

ShapeMass box(const Eigen::Vector3d& edges) {
  const double m = edges.prod();
  const Eigen::Vector3d q = edges.cwiseAbs2();
  return {m, {0, 0, 0}, m / 12 * diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y())};
}

ShapeMass cylinder(double r, double height) {
  const double m = kPi * r * r * height, across = m * (3 * r * r + height * height) / 12;
  return {m, {0, 0, 0}, diagonal(across, across, m * r * r / 2)};
}

/// A cylinder and two half balls, whose centroids stand 3/8 r from their flat sides.
ShapeMass capsule(double r, double height) {
  ShapeMass body = cylinder(r, height);
  const double m = 4 * kPi / 3 * r * r * r, h = height / 2;
  const double across = m * (2 * r * r / 5 + h * h + 3 * h * r / 4);
  body.mass += m;
  body.inertia += diagonal(across, across, m * 2 * r * r / 5);
  return body;
}

/// Sum over the tetrahedra from the origin to every triangle.
ShapeMass solid_mesh(const TriangleMesh& mesh) {
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x'
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    Eigen::Matrix3d V;
    for (int corner = 0; corner < 3; ++corner)
      V.col(corner) = mesh.vertices.col(mesh.triangles(corner, i));
    const double six = V.determinant();
    const Eigen::Vector3d sum = V.rowwise().sum();
    volume += six / 6;
    first += six / 24 * sum;
    second += six / 120 * (V * V.transpose() + sum * sum.transpose());
  }
  if (!(volume > 0)) return {};
  const Eigen::Vector3d com = first / volume;
  const Eigen::Matrix3d C = second - volume * com * com.transpose();
  return {volume, com, C.trace() * Eigen::Matrix3d::Identity() - C};
}

ShapeMass in_own_frame(const ShapeSpec& shape) {
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
      return solid_mesh(shape.mesh);
    case ShapeKind::kTaperedCapsule:
    case ShapeKind::kSuperellipsoid:
      break;
  }
  throw InputError(fmt::format("the mass of a {} has no closed form here", name_of(shape.kind)));
}

}  // namespace

ShapeMass mass_at_unit_density(const ShapeSpec& shape) {
  const ShapeMass own = in_own_frame(shape);
  const Eigen::Matrix3d& R = shape.X_BS.R;
  return {own.mass, shape.X_BS * own.com, R * own.inertia * R.transpose()};
}

ShapeMass together(const std::vector<ShapeMass>& parts) {
  ShapeMass sum;
  for (const ShapeMass& part : parts) {
    sum.mass += part.mass;
    sum.com += part.mass * part.com;
  }
  if (sum.mass > 0) sum.com /= sum.mass;
  for (const ShapeMass& part : parts) {
    const Eigen::Vector3d r = part.com - sum.com;
    sum.inertia += part.inertia +
                   part.mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  return sum;
}

}  // namespace thenar
