#pragma once

/// Geodesics of surfaces, followed from a point in a direction.

#include <Eigen/Core>

#include "tendons/wrapping/bone_surface.h"

namespace thenar {

/// A point of a surface with a direction along it, frame S.
struct SurfaceRay {
  Eigen::Vector3d p;  // on the surface [m] (3)
  Eigen::Vector3d t;  // unit, tangent (3)
};

/// End of a geodesic, and its derivatives by the start.
///
/// The Jacobi fields a and r solve  y'' + K y = 0  along it (K: Gaussian curvature), with
/// a(0) = 1, a'(0) = 0  and  r(0) = 0, r'(0) = 1:  moving the start by beta across the line and
/// turning it there by theta moves the end by  a beta + r theta  across, and turns it by
/// a' beta + r' theta. Source: [Scholz2016].
struct GeodesicEnd {
  SurfaceRay ray;
  double a = 1, da = 0;  // [1], [1/m]
  double r = 0, dr = 1;  // [m], [1]
};

/// Exponential map: follows the geodesic from `start` over `length` (negative: backwards) [m].
/// Exact on spheres, cylinders and capsules (piece by piece); on ellipsoids and tori the equation
///   t' = -(t' S t) n
/// is integrated by extrapolation to rounding, S the shape operator.
[[nodiscard]] GeodesicEnd follow_geodesic(const BoneSurface& surface, const SurfaceRay& start,
                                          double length);

/// Normal and shape operator of the surface at a point on it: no search for a nearest point.
struct SurfaceShapeAt {
  Eigen::Vector3d n;  // outward unit normal (3)
  Eigen::Matrix3d S;  // dn/dp, symmetric, S n = 0 (3, 3) [1/m]
};
[[nodiscard]] SurfaceShapeAt shape_at(const BoneSurface& surface, const Eigen::Vector3d& p_S);

/// A level function: negative inside, zero on the surface, in units of length near it [m].
[[nodiscard]] double level(const BoneSurface& surface, const Eigen::Vector3d& p_S);

/// Puts a point near the surface onto it, moving it along the normal to first order, and makes the
/// direction a unit tangent.
[[nodiscard]] SurfaceRay project_to_surface(const BoneSurface& surface, const SurfaceRay& near);

}  // namespace thenar
