#include "tendons/net/digit_sweep.h"

#include "tendons/net/build_tendons.h"

namespace thenar {
namespace {

/// The net at rest at the first posture, by way of the straight finger; whether it snapped on the
/// way in is not part of the question.
SweepPoint sweep_in(const NetTendons& net, const Eigen::VectorXd& q, const Eigen::VectorXd& t) {
  SweepPoint point;
  point.q = q;
  point.rest = walk_from_straight(net, q, t).rest;
  return point;
}

}  // namespace

std::vector<DigitPoint> sweep_digit(const DigitTendons& tendons,
                                    const std::vector<Eigen::VectorXd>& postures,
                                    const Eigen::VectorXd& t, const Progress& progress) {
  const auto* net = dynamic_cast<const NetTendons*>(&tendons);
  SweepPoint now;  // of a net
  std::vector<DigitPoint> points;
  for (std::size_t i = 0; i < postures.size() && !progress.stop(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(postures.size()), "postures");
    DigitPoint point;
    point.q = postures[i];
    if (net != nullptr) {
      now = i == 0 ? sweep_in(*net, point.q, t) : sweep_on(*net, &now, point.q, t);
      point.rest = now.rest;
      point.snapped = now.snapped;
      point.pull = net->pull_at(point.q, t, now.rest);
    } else {
      point.pull = tendons.pull(point.q, t);
    }
    point.tip = tip_force(tip_statics(tendons.digit(), point.q, t, point.pull), t);
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace thenar
