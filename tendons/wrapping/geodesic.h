#pragma once

/// Geodesics of surfaces, traced from a point in a given direction.

#include <Eigen/Core>

#include "tendons/wrapping/bone_surface.h"

namespace thenar {

/// Point of a surface with a tangent direction, frame S.
struct SurfaceRay {
  Eigen::Vector3d p;  // point on the surface [m] (3)
  Eigen::Vector3d t;  // unit tangent (3)
};

/// End of a geodesic, and its derivatives by the start.
///
/// The Jacobi fields a and r solve  y'' + K y = 0  along it (K: Gaussian curvature), with a(0) = 1,
/// a'(0) = 0  and  r(0) = 0, r'(0) = 1. Shifting the start by beta across the line and turning it
/// there by theta moves the end by  a beta + r theta  across the line and turns it by a' beta + r'
/// theta. Source: [Scholz2016].
struct GeodesicEnd {
  SurfaceRay ray;
  double a = 1, da = 0;  // Jacobi field of a shift and its slope [1], [1/m]
  double r = 0, dr = 1;  // Jacobi field of a turn and its slope [m], [1]
};

/// Computes the exponential map: traces the geodesic from `start` over `length` (negative:
/// backwards) [m]. Exact on spheres, cylinders and capsules (piece by piece); on ellipsoids and
/// tori the equation
///   t' = -(t' S t) n
/// is integrated by extrapolation to rounding, with S the shape operator.
[[nodiscard]] GeodesicEnd follow_geodesic(const BoneSurface& surface, const SurfaceRay& start,
                                          double length);

/// Normal and shape operator of the surface at a point on it.
struct SurfaceCurvature {
  Eigen::Vector3d n;  // outward unit normal (3)
  Eigen::Matrix3d S;  // dn/dp, symmetric, S n = 0 (3, 3) [1/m]
};
/// Computes normal and shape operator at a point that lies on the surface, without a search for the
/// nearest point.
[[nodiscard]] SurfaceCurvature surface_curvature(const BoneSurface& surface,
                                                 const Eigen::Vector3d& p_S);

/// Computes a level function: negative inside, zero on the surface, in units of length near it [m].
[[nodiscard]] double level(const BoneSurface& surface, const Eigen::Vector3d& p_S);

/// Projects a point near the surface onto it, to first order along the normal, and makes the
/// direction a unit tangent.
[[nodiscard]] SurfaceRay project_to_surface(const BoneSurface& surface, const SurfaceRay& near);

}  // namespace thenar
