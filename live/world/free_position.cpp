#include "live/world/free_position.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace thenar {
namespace {

constexpr double kPlacementGap = 0.02;  // gap between a new thing and the others [m]

Eigen::AlignedBox3d bounding_box(const BoundingBalls& balls, const Pose<double>& X) {
  Eigen::AlignedBox3d box;
  for (const Ball& ball : balls) {
    const Eigen::Vector3d center = X * ball.c, reach = Eigen::Vector3d::Constant(ball.r);
    box.extend(Eigen::AlignedBox3d(center - reach, center + reach));
  }
  return box;
}

}  // namespace

Eigen::Vector3d free_position(const WorldState& state, const BoundingBalls& balls,
                              const Eigen::Matrix3d& R) {
  // Compute the box of the new thing in its rotation.
  const Eigen::AlignedBox3d own = bounding_box(balls, {R, Eigen::Vector3d::Zero()});
  if (own.isEmpty()) return Eigen::Vector3d::Zero();
  bool free = true;
  double end = 0;
  // Test the origin against all boxes, and find the largest x of all boxes.
  const auto keep_clear_of = [&](const Eigen::AlignedBox3d& other) {
    if (other.isEmpty()) return;
    free = free && !own.intersects(other);
    end = std::max(end, other.max().x());
  };
  for (const StateHand& hand : state.hands)
    keep_clear_of(bounding_box(hand.built->balls, hand.placement.X_WH));
  for (const StateBody& body : state.bodies)
    keep_clear_of(bounding_box({body.built->ball}, body.X_WB));
  // Use the origin if it is free, else the position beside all boxes along x.
  if (free) return Eigen::Vector3d::Zero();
  return {end + kPlacementGap - own.min().x(), 0, 0};
}

}  // namespace thenar
