#pragma once

/// Balls and half-spaces near a body that are known to be empty, from evaluations of its distance.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "geometry/collision/collision_tree.h"
#include "geometry/shape.h"

namespace thenar {

/// Balls and half-spaces that hold no part of a body B: they bound its distance without evaluating
/// it. All in B's frame.
class EmptySpace {
 public:
  /// Records an empty ball; the first eight are kept.
  void add_ball(const Ball& ball);

  /// Records that B lies in  n . x <= offset  [m]; the last eight planes are kept. @param n  unit
  /// (3)
  void add_plane(const Eigen::Vector3d& n, double offset);

  [[nodiscard]] bool has_planes() const { return planes_seen_ > 0; }

  /// Returns a lower bound of the distance of B to any point of a ball [m].
  [[nodiscard]] double bound(const Ball& ball) const;

  /// Returns a lower bound of the distance of B to a triangle swept by a ball of a radius [m].
  /// @param corners  columns (3, 3)
  [[nodiscard]] double bound(const Eigen::Matrix3d& corners, double radius) const;

 private:
  struct Plane {
    Eigen::Vector3d n;  // unit, outward of B (3)
    double offset;      // [m]
  };
  static constexpr std::size_t kMaxKept = 8;

  [[nodiscard]] std::size_t plane_count() const { return std::min(planes_seen_, kMaxKept); }

  std::vector<Ball> balls_;
  std::array<Plane, kMaxKept> planes_{};
  std::size_t planes_seen_ = 0;
};

/// Returns an empty ball whose rim is near the surface, so that points in it are at least as far
/// from the solid as from the rim: a triangle with corners within r' of the centre is no nearer
/// than r - r'.
///
/// The ball has its centre at c + h n. The offset h is chosen so that its rim, which lies below the
/// plane through c perpendicular to n by  r^2 / 2h,  proves that no point of the triangle is nearer
/// than wanted, if d grows by h along n, as it does up to the ridge of a concavity. As d changes by
/// at most the distance moved, the bound holds everywhere, up to the shape's accuracy.
/// @param ball    bounding ball of the corners [m];  @param seen  b.nearest(ball.c)
/// @param wanted  value that the bound should exceed [m]
/// @return  radius minus infinity if the plane shows that no such ball exists [m]
[[nodiscard]] Ball lifted_ball(const Shape& b, const Eigen::Matrix3d& corners, const Ball& ball,
                               const NearestSurface& seen, double wanted);

/// Returns a lower bound of the distance of a triangle from the solid, given an empty ball [m].
[[nodiscard]] double triangle_bound(const Ball& empty, const Eigen::Matrix3d& corners);

}  // namespace thenar
