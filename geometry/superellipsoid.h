#pragma once

/// Superellipsoids: boxes, cylinders, balls, octahedra and the shapes between them.

#include <memory>

#include "geometry/shape.h"

namespace thenar {

/// Builds the solid  ((x/a)^(2/e2) + (y/b)^(2/e2))^(e2/e1) + (z/c)^(2/e1) <= 1  [Barr1981]; it is
/// convex, as the left side is a power of a norm N.
///
/// Its signed distance is the maximum of  n . (p - x)  over its surface points x with their normals
/// n. From the point p / N(p), moved along the surface by Newton's method, outside usually a bound
/// is found that equals |p - x| within 1e-12 of the size, so that no point can be nearer. Elsewhere
/// (deep inside, where several sides compete; at edges so sharp that Newton's method does not
/// converge, with exponents close to 2) the search starts from the nearest point of a fine
/// tessellation of one octant. That is correct within accuracy(), 3e-4 of the largest semi-axis;
/// usually Newton's method improves it to rounding. The nearest surface then supports the solid,
/// except where it comes from the tessellation.
///
/// @param semi_axes  a, b, c [m] (3)
/// @param exponents  e1, e2 in [0.1, 2] [1] (2): at 0.1 the radius of edges is about 1/14 of the
///                   semi-axes, at 2 edges are sharp
[[nodiscard]] std::shared_ptr<const Shape> build_superellipsoid(const Eigen::Vector3d& semi_axes,
                                                                const Eigen::Vector2d& exponents);

/// Returns the point of a superellipsoid farthest along a direction n of any length [m] (3).
[[nodiscard]] Eigen::Vector3d superellipsoid_support(const Eigen::Vector3d& semi_axes,
                                                     const Eigen::Vector2d& exponents,
                                                     const Eigen::Vector3d& n);

}  // namespace thenar
