#pragma once

/// Solids with a signed distance in closed form, or exact to rounding, centred at the origin of
/// their own frames (see ShapeSpec). Sizes are positive and finite, as build_solid() checks. All
/// are convex, and their nearest surface supports them.

#include <memory>

#include "geometry/shape.h"

namespace thenar {

/// Builds a sphere:  |p| - r. @param radius  [m]
[[nodiscard]] std::shared_ptr<const Shape> build_sphere(double radius);

/// Builds a box. @param edges  full lengths [m] (3)
[[nodiscard]] std::shared_ptr<const Shape> build_box(const Eigen::Vector3d& edges);

/// Builds a cylinder about z. @param radius  [m]  @param height  full height [m]
[[nodiscard]] std::shared_ptr<const Shape> build_cylinder(double radius, double height);

/// Builds the hull of two balls, of radius `lower` at z = -length / 2 and `upper` at z = +length /
/// 2; with equal radii it is a capsule. If one ball contains the other, it is the solid.
///
/// In the half plane of (rho, z) the surface is an arc, a straight line tangent to both balls, at
/// the angle sin(alpha) = (lower - upper) / length to the axis, and an arc; the projection of a
/// point on the line shows which of them is nearest, inside and outside.
/// @param lower, upper, length  [m]
[[nodiscard]] std::shared_ptr<const Shape> build_tapered_capsule(double lower, double upper,
                                                                 double length);

/// Builds an ellipsoid. The point x nearest to y has  x_i = e_i^2 y_i / (e_i^2 + t)  with t the
/// largest root of  sum (e_i y_i / (e_i^2 + t))^2 = 1. Newton's method on the inverse root of this
/// sum, which is concave, converges from below without overshooting [Eberly2013].
/// @param semi_axes  [m] (3)
[[nodiscard]] std::shared_ptr<const Shape> build_ellipsoid(const Eigen::Vector3d& semi_axes);

}  // namespace thenar
