#pragma once

/// Mass, centre and inertia of a solid of uniform density.

#include <Eigen/Core>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// Mass, centre of mass and inertia of a body.
struct MassProperties {
  double mass = 0;                  // [kg]
  Eigen::Vector3d centre{0, 0, 0};  // [m] (3)
  /// About the centre, along the mesh axes [kg m^2] (3, 3).
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// Computes the mass properties at density 1 kg/m^3, exact for the polyhedron: sums over the
/// tetrahedra between the mean of the vertices and each triangle,  integral of x x^T = det(A) A C
/// A^T,  with A the corners as columns and C the moments of the unit tetrahedron (1/60 on the
/// diagonal, 1/120 off it). For an open surface they depend on that mean; overlapping parts are all
/// counted. Source: [Mirtich1996] for the idea of exact integration over faces; the sum over
/// tetrahedra is another form of it.
[[nodiscard]] MassProperties signed_moments(const TriangleMesh& mesh);

/// Computes the mass properties of a closed mesh at a density.
/// @param mesh     watertight, outward
/// @param density  [kg/m^3]
/// @throws InputError if the mesh is not closed (the message names its holes), encloses no volume,
/// or the density is not positive and finite.
[[nodiscard]] MassProperties mass_properties(const TriangleMesh& mesh, double density);

}  // namespace thenar
