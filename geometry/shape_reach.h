#pragma once

/// Maximum distance of a solid's points from a given point.

#include <Eigen/Core>

#include "geometry/shape_spec.h"

namespace thenar {

/// Returns the maximum distance of the surface of a shape from a point of its body [m]: exact,
/// except for ellipsoids and superellipsoids, where it is found by ascent and may be too small by
/// 1e-5 of the size.
/// @param shape  valid for build_solid()
/// @throws InputError if `from` is not finite.
[[nodiscard]] double reach_of(const ShapeSpec& shape, const Eigen::Vector3d& from);

}  // namespace thenar
