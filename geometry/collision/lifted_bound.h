#pragma once

/// How near a triangle can be to a solid whose distance is known at a few points.

#include <Eigen/Core>

#include "geometry/collision/touch_body.h"
#include "geometry/shape.h"

namespace thenar {

/// A ball without a point of the solid, so that nothing in it is nearer than its rim is far:
/// a triangle whose corners lie within r' of its centre is no nearer than  r - r'.
///
/// It stands on the surface as the ball about c + h n does, h chosen so that its rim, which sinks
/// below the plane through c across n by  r^2 / 2h,  tells that nothing in the triangle is nearer
/// than wanted, if d grows by h along n, as it does up to the ridge of a hollow. The law that d
/// changes by no more than the way gone holds everywhere, so does the bound, but for the shape's
/// accuracy.
/// @param ball  around the corners [m];  @param seen  b.nearest(ball.c)
/// @param wanted  what the bound ought to exceed [m]
/// @return  of radius minus infinity if the plane says at once that it cannot [m]
[[nodiscard]] Ball lifted_ball(const Shape& b, const Eigen::Matrix3d& corners, const Ball& ball,
                               const NearestSurface& seen, double wanted);

/// No point of the triangle is nearer than this, by what an empty ball tells [m].
[[nodiscard]] double bound_by(const Ball& empty, const Eigen::Matrix3d& corners);

}  // namespace thenar
