#include "grasp/draw_start.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/spatial.h"
#include "grasp/draw_uniform.h"

namespace thenar {
namespace {

constexpr double kClear = 1e-3;  // left between the hand and the object at the start [m]

Eigen::Vector3d draw_direction(std::mt19937& random) {
  const double z = 2 * draw_uniform(random) - 1, turn = 2 * kPi * draw_uniform(random);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Turns `from` to `to`, then about `to`.
Eigen::Matrix3d turn_to(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double roll) {
  const Tangents a = tangents(from), b = tangents(to);
  Eigen::Matrix3d A, B;
  A << a.e1, a.e2, from;
  B << b.e1, b.e2, to;
  return rotation_about<double>(to, roll) * B * A.transpose();
}

/// How far any surface is from the point of approach [m].
double hand_reach(const TouchingHand& hand, const Eigen::VectorXd& q) {
  const PalmApproach& approach = hand.hand->layout().approach;
  const std::vector<Pose<double>> links = hand.hand->pose(q);
  double reach = 0;
  for (std::size_t s = 0; s < hand.touch.size(); ++s) {
    const Ball& ball = hand.touch[s].nodes[0].ball;
    const int link = hand.hand->surfaces()[s].link;
    const Eigen::Vector3d c = link < 0 ? ball.c : links[link] * ball.c;
    reach = std::max(reach, (c - approach.point).norm() + ball.r);
  }
  return reach;
}

}  // namespace

Pose<double> draw_start(const TouchingHand& hand, const Eigen::VectorXd& q, const SceneBody& object,
                        std::mt19937& random) {
  const Eigen::Vector3d from = draw_direction(random);
  const double roll = 2 * kPi * draw_uniform(random);
  const Eigen::Vector3d off = draw_direction(random) * std::cbrt(draw_uniform(random));
  const Eigen::Vector3d aim = object.X_WB * object.com + object.reach / 2 * off;
  const PalmApproach& approach = hand.hand->layout().approach;

  Pose<double> X_WH;
  X_WH.R = turn_to(approach.direction, -from, roll);
  const double away = 1.5 * object.reach + hand_reach(hand, q) + kClear;
  X_WH.p = aim + away * from - X_WH.R * approach.point;
  return X_WH;
}

double way_past(const TouchingHand& hand, const Eigen::VectorXd& q, const SceneBody& object) {
  return 2 * (1.5 * object.reach + hand_reach(hand, q) + kClear);
}

}  // namespace thenar
