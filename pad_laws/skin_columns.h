#pragma once

/// Columns of a FoundationBed under the skin near a point.

#include <Eigen/Core>

#include "geometry/triangle_mesh.h"
#include "pad_laws/foundation_bed.h"

namespace thenar {

/// Builds the columns under the skin within 10 mm of a point: one column for each piece of a
/// triangle, with no side longer than 0.7 mm, along the normal of the triangle.
/// @param skin       surface in the pad's frame [m]
/// @param p          point in the pad's frame [m] (3)
/// @param thickness  thickness of the layer under the skin [m]
[[nodiscard]] FoundationColumns skin_columns(const TriangleMesh& skin, const Eigen::Vector3d& p,
                                             double thickness);

}  // namespace thenar
