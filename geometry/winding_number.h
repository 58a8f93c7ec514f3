#pragma once

/// Winding numbers of closed surfaces.

#include <Eigen/Core>

#include "geometry/triangle_tree.h"

namespace thenar::internal {

/// Computes the winding number of a closed surface around a point off it, from the triangles that a
/// ray crosses: outwards they count 1, inwards -1. If a ray passes an edge within rounding, another
/// direction is used.
/// @param tree  tree of the surface
[[nodiscard]] int winding_number(const TriangleTree& tree, const Eigen::Vector3d& p);

}  // namespace thenar::internal
