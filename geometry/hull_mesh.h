#pragma once

/// Convex hull of points as a mesh.

#include <Eigen/Core>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// Returns the hull, watertight and outward, within 1e-6 of the points' extent: each point is moved
/// by up to half of that, always in the same way, so that no four points are coplanar. It is empty
/// if the hull's minimum thickness is below 1e-4 of its extent.
/// @param points  (3, n) [m]
/// @throws InputError if a coordinate is not finite.
[[nodiscard]] TriangleMesh hull_mesh(const Eigen::Matrix3Xd& points);

}  // namespace thenar
