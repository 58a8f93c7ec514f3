#pragma once

/// What a search has learnt of the space beside a body.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "geometry/collision/touch_body.h"

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

  /// B is no nearer than this to any point of a ball [m].
  [[nodiscard]] double bound(const Ball& ball) const;

  /// The same for a triangle grown by a radius [m]. @param corners  columns (3, 3)
  [[nodiscard]] double bound(const Eigen::Matrix3d& corners, double radius) const;

 private:
  struct Plane {
    Eigen::Vector3d n;  // unit, outward of B (3)
    double offset;      // [m]
  };
  static constexpr std::size_t kMost = 8;

  [[nodiscard]] std::size_t planes() const { return std::min(planes_seen_, kMost); }

  std::vector<Ball> balls_;
  std::array<Plane, kMost> planes_{};
  std::size_t planes_seen_ = 0;
};

}  // namespace thenar
