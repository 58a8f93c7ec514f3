#pragma once

/// Solids of other formats that a transform leaves what they are.

#include <optional>

#include <Eigen/Geometry>

#include "geometry/shape_spec.h"

namespace thenar {

/// A sphere, box or cylinder under an affine map p -> A p + b, where its image is one again: A has
/// columns at right angles in the frame of the solid, all of the same length for a sphere, those
/// across the axis of the same length for a cylinder; any lengths for a box. A mirror changes none
/// of them. Angles and ratios of lengths count as equal within 1e-6, as files of single precision
/// have them; the rotation is then the nearest to A.
/// @param solid  size and X_BS in the unit of the file
/// @return nothing if it becomes another solid, or a size is not > 0 and finite
[[nodiscard]] std::optional<ShapeSpec> place_primitive(const ShapeSpec& solid,
                                                       const Eigen::Affine3d& map);

/// The solid where one unit is `scale` [m].
[[nodiscard]] ShapeSpec scaled_primitive(ShapeSpec solid, double scale);

/// The decimal number that a float was most likely read from: the shortest one that rounds to it,
/// so that 0.035 stays 0.035.
[[nodiscard]] double shortest_decimal(float value);

}  // namespace thenar
