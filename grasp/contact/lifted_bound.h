#pragma once

/// How near a triangle can be to a solid whose distance is known at a few points.

#include <Eigen/Core>

#include "base/shapes/shape.h"
#include "grasp/contact/touch_body.h"

namespace thenar {

/// A bound that all distances of a triangle exceed, less the shape's accuracy.
///
/// The ball about  c + h n  through the corners holds the triangle, so that no point of it is
/// nearer than  d(c + h n) - r.  Where d grows by h along n, as it does up to the ridge of a
/// hollow, this is below the plane through c across n by  r^2 / 2h  only: enough, at h = r^2 /
/// (lowest point of that plane - wanted), to tell that nothing is nearer than wanted. The law that
/// d changes by no more than the way gone holds everywhere, so does the bound.
/// @param ball  around the corners [m];  @param seen  b.nearest(ball.c)
/// @param wanted  what the bound ought to exceed [m]
/// @return  minus infinity if the plane says at once that it cannot [m]
[[nodiscard]] double lifted_bound(const Shape& b, const Eigen::Matrix3d& corners, const Ball& ball,
                                  const NearestSurface& seen, double wanted);

}  // namespace thenar
