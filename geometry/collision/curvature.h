#pragma once

/// Curvatures of surfaces at their contacts.

#include <Eigen/Core>

#include "geometry/shape.h"

namespace thenar {

/// Principal curvatures at a point of a surface; positive where it is convex.
struct PrincipalCurvatures {
  double k1 = 0;                // larger curvature [1/m]
  double k2 = 0;                // smaller curvature [1/m]
  Eigen::Vector3d d1{1, 0, 0};  // unit direction of k1, tangent to the surface (3)
};

/// Computes curvatures of a shape from second differences of its distance in four directions
/// perpendicular to the normal,  d_vv = (d(p + h v) + d(p - h v) - 2 d(p)) / h^2,  as the Hessian
/// of a distance is that of its surface. An arc of curvature k gives  k (1 - (h k)^2 / 4 + ...);
/// errors s of the distance (accuracy(), or the sagitta of facets) contribute  4 s / h^2.  The best
/// h is near the size of the contact patch, and larger than a mesh's facets.
/// @param p     point on the surface, or near it [m] (3)
/// @param step  step h [m]
/// @throws InputError if p is not finite, or the step not positive and finite.
[[nodiscard]] PrincipalCurvatures curvatures(const Shape& shape, const Eigen::Vector3d& p,
                                             double step = 1e-3);

/// Curvatures of the gap between two surfaces in contact: its height is (k1 x^2 + k2 y^2) / 2.
struct RelativeCurvatures {
  double k1 = 0;  // larger curvature, in the direction in which the gap opens fastest [1/m]
  double k2 = 0;  // smaller curvature [1/m]
};

/// Computes the relative curvatures from the sum of the Hessians of both surfaces,
///   k1 + k2 = a.k1 + a.k2 + b.k1 + b.k2,
///   (k1 - k2)^2 = A^2 + B^2 + 2 A B cos(2 angle),  A = a.k1 - a.k2,  B = b.k1 - b.k2.
/// @param angle  between the directions d1 of both [rad]
/// Source: [Johnson1985], section 4.1.
[[nodiscard]] RelativeCurvatures relative_curvatures(const PrincipalCurvatures& a,
                                                     const PrincipalCurvatures& b, double angle);

}  // namespace thenar
