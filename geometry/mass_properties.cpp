#include "geometry/mass_properties.h"

#include <cmath>

#include <Eigen/LU>

#include "base/error.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_parts.h"

namespace thenar {

using Eigen::Matrix3d, Eigen::Vector3d;

MassProperties signed_moments(const TriangleMesh& mesh) {
  // Start from the mean of the vertices, so that little cancels out.
  const Vector3d origin = mesh.vertices.rowwise().mean();
  const Matrix3d unit = (Matrix3d::Ones() + Matrix3d::Identity()) / 120;
  // Sum the moments of the tetrahedra under each triangle.
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    Matrix3d A;
    for (int k = 0; k < 3; ++k) A.col(k) = mesh.vertices.col(mesh.triangles(k, t)) - origin;
    const double det = A.determinant();
    volume += det / 6;
    first += det / 24 * A.rowwise().sum();
    second += det * A * unit * A.transpose();
  }
  // Move the moments to the centre.
  if (volume == 0) return {};
  const Vector3d centre = first / volume;
  second -= volume * centre * centre.transpose();
  return {volume, origin + centre, second.trace() * Matrix3d::Identity() - second};
}

MassProperties mass_properties(const TriangleMesh& mesh, double density) {
  require(density > 0 && std::isfinite(density), "a density must be positive and finite, got {}",
          density);
  const MeshReport report = check_mesh(mesh);
  if (!report.holes.empty())
    throw InputError("a mesh bounds no solid: " + explain_open_mesh(mesh, report));
  require(report.volume > 0, "a mesh encloses {} m^3", report.volume);
  MassProperties result = signed_moments(mesh);
  result.mass *= density;
  result.inertia *= density;
  return result;
}

}  // namespace thenar
