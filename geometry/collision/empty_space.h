#pragma once

/// Balls and half-spaces known to be empty beside a body, from earlier looks at its distance.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "geometry/collision/collision_tree.h"
#include "geometry/shape.h"

namespace thenar {

/// Balls and half-spaces known to hold no part of a body B: bounds of its distance that cost no
/// look at it. All in B's frame.
class EmptySpace {
 public:
  /// The first eight balls are kept.
  void add_ball(const Ball& ball);

  /// B lies in  n . x <= offset  [m]; the last eight planes are kept. @param n  unit (3)
  void add_plane(const Eigen::Vector3d& n, double offset);

  [[nodiscard]] bool has_planes() const { return planes_seen_ > 0; }

  /// Returns a lower bound of the distance of B to any point of a ball [m].
  [[nodiscard]] double bound(const Ball& ball) const;

  /// Returns a lower bound of the distance of B to a triangle grown by a radius [m].
  /// @param corners  columns (3, 3)
  [[nodiscard]] double bound(const Eigen::Matrix3d& corners, double radius) const;

 private:
  struct Plane {
    Eigen::Vector3d n;  // unit, outward of B (3)
    double offset;      // [m]
  };
  static constexpr std::size_t kMaxKept = 8;

  [[nodiscard]] std::size_t planes() const { return std::min(planes_seen_, kMaxKept); }

  std::vector<Ball> balls_;
  std::array<Plane, kMaxKept> planes_{};
  std::size_t planes_seen_ = 0;
};

// Bounds of a triangle's distance from a solid whose distance is known at a few points.

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
