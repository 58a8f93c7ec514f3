#include "grasp/link_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thenar {
namespace {

constexpr double kLongestTurn = 1.5;  // e^x - 1 <= x + x^2 up to 1.79 [rad]

}  // namespace

SurfaceSpeed surface_speed(const Hand& hand, const Eigen::VectorXd& q, const Eigen::VectorXd& q_dot,
                           int surface, const Ball& ball) {
  const int link = hand.surfaces()[surface].link;
  if (link < 0) return {Eigen::VectorXd::Zero(q.size()), Eigen::VectorXd::Zero(q.size())};
  const auto J = hand.jacobian(q, link, ball.c);
  const Eigen::VectorXd rate = q_dot.cwiseAbs();
  const Eigen::VectorXd turn = J.topRows<3>().colwise().norm().transpose().cwiseProduct(rate);
  const Eigen::VectorXd centre = J.bottomRows<3>().colwise().norm().transpose().cwiseProduct(rate);
  return {centre + ball.r * turn, turn};
}

double safe_time(double speed, double turn, double gap) {
  if (speed <= 0) return std::numeric_limits<double>::infinity();
  // speed turn t^2 + speed t = gap, in a form that does not cancel.
  const double time = 2 * gap / speed / (1 + std::sqrt(1 + 4 * turn * gap / speed));
  return turn > 0 ? std::min(time, kLongestTurn / turn) : time;
}

double longest_way(double speed, double turn, double time) {
  return speed * time * (1 + turn * time);
}

}  // namespace thenar
