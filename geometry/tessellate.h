#pragma once

/// Triangle meshes of primitive solids: watertight, counterclockwise seen from outside.

#include <vector>

#include "geometry/shape.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Builds a box of twelve triangles. @param edges  [m] (3)
[[nodiscard]] TriangleMesh box_mesh(const Eigen::Vector3d& edges);

/// Builds the surface that a profile (rho, z) sweeps about z. The profile begins and ends on the
/// axis, and runs upwards with the solid on its left as rho grows to the right.
/// @param profile  at least three points [m] (2)
/// @param sides    at least three
[[nodiscard]] TriangleMesh surface_of_revolution(const std::vector<Eigen::Vector2d>& profile,
                                                 int sides);

/// Returns the number of sides of a regular polygon whose deviation from a circle is at most
/// `tolerance` inside and outside, if its corners are outside the circle by corner_overshoot().
/// @param radius, tolerance  [m]
[[nodiscard]] int sides_of_circle(double radius, double tolerance);

/// Returns the distance of the corners of this polygon outside the circle, over its radius [1].
[[nodiscard]] double corner_overshoot(int sides);

/// Builds triangles within about `tolerance` of a convex solid around the origin, on either side of
/// its surface: edges are halved until their midpoints are near enough, for both triangles of an
/// edge together, so that no gap opens; then corners are moved out by half of the depth of the
/// triangles.
/// @param tolerance  [m]
[[nodiscard]] TriangleMesh tessellate(const Shape& convex, double tolerance);

/// Builds the part of tessellate() without negative coordinates, of a solid that is symmetric about
/// all three planes; it is open. The distances need only have the right sign and vanish on the
/// surface.
[[nodiscard]] TriangleMesh tessellate_octant(const Shape& convex, double tolerance);

}  // namespace thenar
