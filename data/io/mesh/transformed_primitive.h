#pragma once

/// Transforms that map spheres, boxes and cylinders to such solids.

#include <optional>

#include <Eigen/Geometry>

#include "geometry/shape_spec.h"

namespace thenar {

/// Returns the image of a sphere, box or cylinder under an affine map p -> A p + b, if it is such a
/// solid again: A has perpendicular columns in the frame of the solid, of equal length for a
/// sphere, of equal length across the axis for a cylinder, of any length for a box. Mirroring
/// changes none of them. Angles and ratios of lengths count as equal within 1e-6, the precision of
/// single-precision files; the rotation is then the nearest to A.
/// @param solid  size and X_BS in the unit of the file
/// @returns nothing if it becomes another solid, or a size is not > 0 and finite
[[nodiscard]] std::optional<ShapeSpec> place_primitive(const ShapeSpec& solid,
                                                       const Eigen::Affine3d& map);

/// Returns the solid in metres. @param scale  [m] per unit of its size
[[nodiscard]] ShapeSpec scaled_primitive(ShapeSpec solid, double scale);

/// Returns the decimal number from which a float was most likely read: the shortest that rounds to
/// it, so that 0.035 stays 0.035.
[[nodiscard]] double shortest_decimal(float value);

}  // namespace thenar
