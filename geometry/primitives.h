#pragma once

/// Solids whose signed distance is known in closed form, or to rounding,
/// centred at the origin of their own frames (see ShapeSpec). Sizes are
/// positive and finite: build_solid() sees to it. All are convex, and what they
/// tell of the nearest surface supports them.

#include <memory>

#include "geometry/shape.h"

namespace thenar {

/// |p| - r. @param radius  [m]
[[nodiscard]] std::shared_ptr<const Shape> build_sphere(double radius);

/// @param edges  full lengths [m] (3)
[[nodiscard]] std::shared_ptr<const Shape> build_box(const Eigen::Vector3d& edges);

/// About z. @param radius  [m]  @param height  full [m]
[[nodiscard]] std::shared_ptr<const Shape> build_cylinder(double radius, double height);

/// The hull of two balls, of radius `lower` at z = -length / 2 and `upper` at z
/// = +length / 2; of equal radii a capsule. Where one ball holds the other, it
/// is the solid.
///
/// Seen in the half plane of (rho, z) the surface is an arc, a straight line
/// that touches both balls, sin(alpha) = (lower - upper) / length from the
/// axis, and an arc; the foot of the point on the line tells which of them is
/// nearest, within and without.
/// @param lower, upper, length  [m]
[[nodiscard]] std::shared_ptr<const Shape> build_tapered_capsule(double lower, double upper,
                                                                 double length);

/// The point x of the ellipsoid nearest to y has  x_i = e_i^2 y_i / (e_i^2 + t)
/// with t the largest root of  sum (e_i y_i / (e_i^2 + t))^2 = 1. Newton's
/// method on the inverse root of this sum, which is concave, comes from below
/// without overshooting [Eberly2013].
/// @param semi_axes  [m] (3)
[[nodiscard]] std::shared_ptr<const Shape> build_ellipsoid(const Eigen::Vector3d& semi_axes);

}  // namespace thenar
