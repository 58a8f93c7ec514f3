#pragma once

/// Surfaces of primitive solids as triangles: watertight, counterclockwise seen
/// from outside.

#include <vector>

#include "geometry/shape.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Twelve triangles. @param edges  [m] (3)
[[nodiscard]] TriangleMesh box_mesh(const Eigen::Vector3d& edges);

/// The surface swept by a profile (rho, z) about z. It begins and ends on the
/// axis, and runs from below to above with the solid to its left as rho grows
/// to the right.
/// @param profile  at least three points [m] (2)
/// @param sides    at least three
[[nodiscard]] TriangleMesh surface_of_revolution(const std::vector<Eigen::Vector2d>& profile,
                                                 int sides);

/// Sides of a regular polygon that crosses a circle and leaves it by no more
/// than `tolerance` either way, when its corners stand outside by outside_by().
/// @param radius, tolerance  [m]
[[nodiscard]] int sides_of_circle(double radius, double tolerance);

/// Returns the distance by which the corners of this polygon stand outside the circle, over its
/// radius [1].
[[nodiscard]] double outside_by(int sides);

/// Triangles within about `tolerance` of a convex solid around the origin, to
/// either side of its surface: edges are halved until their middles lie near
/// enough, both triangles of an edge at once, so that no gap can open; then
/// corners are moved out by half of what triangles sink in.
/// @param tolerance  [m]
[[nodiscard]] TriangleMesh tessellate(const Shape& convex, double tolerance);

/// The part of tessellate() where no coordinate is negative, of a solid that is symmetric about all
/// three planes; open. The distances may be rough, if they have the right sign and vanish on the
/// surface.
[[nodiscard]] TriangleMesh tessellate_octant(const Shape& convex, double tolerance);

}  // namespace thenar
