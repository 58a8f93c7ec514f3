#pragma once

/// Largest distance of a solid's points from a given point.

#include <Eigen/Core>

#include "geometry/shape_spec.h"

namespace thenar {

/// Largest distance of the surface of a shape from a point of its body [m]: exact, but of
/// ellipsoids and superellipsoids, where it is found by ascent and may be too short by 1e-5 of the
/// size.
/// @param shape  that build_solid() takes
/// @throws InputError if `from` is not finite.
[[nodiscard]] double reach_of(const ShapeSpec& shape, const Eigen::Vector3d& from);

}  // namespace thenar
