#include "live/world/free_place.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace thenar {
namespace {

constexpr double kGap = 0.02;  // between a new thing and the others [m]

Eigen::AlignedBox3d box_about(const OwnBalls& balls, const Pose<double>& X) {
  Eigen::AlignedBox3d box;
  for (const Ball& ball : balls) {
    const Eigen::Vector3d center = X * ball.c, reach = Eigen::Vector3d::Constant(ball.r);
    box.extend(Eigen::AlignedBox3d(center - reach, center + reach));
  }
  return box;
}

}  // namespace

Eigen::Vector3d free_place(const WorldState& state, const OwnBalls& balls,
                           const Eigen::Matrix3d& R) {
  // Bound the new thing by its balls, as it will be turned.
  const Eigen::AlignedBox3d own = box_about(balls, {R, Eigen::Vector3d::Zero()});
  if (own.isEmpty()) return Eigen::Vector3d::Zero();
  bool free = true;
  double end = 0;
  // Leave it at the origin if it is clear of everything there, else put it beside all others along
  // x.
  const auto mind = [&](const Eigen::AlignedBox3d& other) {
    if (other.isEmpty()) return;
    free = free && !own.intersects(other);
    end = std::max(end, other.max().x());
  };
  for (const StateHand& hand : state.hands) mind(box_about(hand.built->balls, hand.stand.X_WH));
  for (const StateBody& body : state.bodies) mind(box_about({body.built->ball}, body.X_WB));
  if (free) return Eigen::Vector3d::Zero();
  return {end + kGap - own.min().x(), 0, 0};
}

}  // namespace thenar
