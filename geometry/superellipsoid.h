#pragma once

/// Superellipsoids: boxes, cylinders, balls, octahedra and the shapes between them.

#include <memory>

#include "geometry/shape.h"

namespace thenar {

/// The solid  ((x/a)^(2/e2) + (y/b)^(2/e2))^(e2/e1) + (z/c)^(2/e1) <= 1  [Barr1981]; convex, as the
/// left side is a power of a norm N.
///
/// Its signed distance is the largest of  n . (p - x)  over its surface points x with their normals
/// n. From the point p / N(p), moved along the surface by Newton's method, a bound is usually found
/// outside that equals |p - x| within 1e-12 of the size, so that nothing can be nearer. Elsewhere
/// (deep inside, where several sides compete; at edges so sharp that Newton's method does not
/// settle, with exponents close to 2) the search starts from the nearest point of a fine
/// tessellation of one octant. That is right within accuracy(), 3e-4 of the largest semi-axis;
/// usually Newton's method improves it to rounding. The nearest surface then supports the solid,
/// except where the tessellation has the last word.
///
/// @param semi_axes  a, b, c [m] (3)
/// @param exponents  e1, e2 in [0.1, 2] [1] (2): at 0.1 edges are round by about a fourteenth
///                   of the semi-axes, at 2 they are sharp
[[nodiscard]] std::shared_ptr<const Shape> build_superellipsoid(const Eigen::Vector3d& semi_axes,
                                                                const Eigen::Vector2d& exponents);

/// Point of a superellipsoid farthest along a direction n, which need not be a unit vector [m] (3).
[[nodiscard]] Eigen::Vector3d superellipsoid_support(const Eigen::Vector3d& semi_axes,
                                                     const Eigen::Vector2d& exponents,
                                                     const Eigen::Vector3d& n);

}  // namespace thenar
