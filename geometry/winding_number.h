#pragma once

/// Winding numbers of closed surfaces.

#include <Eigen/Core>

#include "geometry/triangle_tree.h"

namespace thenar::internal {

/// The winding number of a closed surface around a point off it, by the triangles that a ray
/// crosses: outwards count 1, inwards -1. A ray that passes an edge within rounding gives way to
/// one of another direction.
/// @param tree  of the surface
[[nodiscard]] int windings(const TriangleTree& tree, const Eigen::Vector3d& p);

}  // namespace thenar::internal
