#pragma once

/// Which way two bodies press each other where one or both are sharp.

#include <Eigen/Core>

#include "base/spatial.h"
#include "geometry/collision/patch_search.h"
#include "geometry/collision/touch_body.h"

namespace thenar {

/// The direction of a contact, into B.
///
///   A rounded there:         the inward normal of B as A's core sees it; it is A's as well
///   B smooth there:          B's inward normal
///   B sharp, A smooth:       A's normal, whichever of both signs points into B
///   B sharp, A sharp too:    A's normal on a face that lies on one of B, within 10 degrees; else
///                            B's inward normal on one that looks the same way; without such a
///                            pair the inward middle of B's normals there
///
/// B is sharp where normals at points 0.1 mm around turn away from each other by more than 30
/// degrees; A is where its triangles within 0.1 mm do.
/// @return  unit, in B's frame (3)
[[nodiscard]] Eigen::Vector3d into_b(const PatchPoint& point, const TouchBody& a,
                                     const Pose<double>& X_BA, const Shape& b);

}  // namespace thenar
