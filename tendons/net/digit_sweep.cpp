#include "tendons/net/digit_sweep.h"

#include "tendons/net/build_tendons.h"

namespace thenar {
namespace {

constexpr int kWayIn = 10;  // postures between the straight finger and the first one

/// The net at rest at every posture, by way of the straight finger.
std::vector<SweepPoint> sweep_from_straight(const NetTendons& net,
                                            const std::vector<Eigen::VectorXd>& postures,
                                            const Eigen::VectorXd& t) {
  std::vector<Eigen::VectorXd> way =
      postures_between(net.net().frame.straight, postures.front(), kWayIn);
  way.insert(way.end(), postures.begin() + 1, postures.end());
  std::vector<SweepPoint> points = sweep_net(net, way, t);
  points.erase(points.begin(), points.begin() + kWayIn);
  points.front().snapped = false;  // on the way in is not part of the question
  return points;
}

}  // namespace

std::vector<DigitPoint> sweep_digit(const DigitTendons& tendons,
                                    const std::vector<Eigen::VectorXd>& postures,
                                    const Eigen::VectorXd& t, const Progress& progress) {
  const auto* net = dynamic_cast<const NetTendons*>(&tendons);
  std::vector<SweepPoint> at_rest;
  if (net != nullptr && !postures.empty()) at_rest = sweep_from_straight(*net, postures, t);
  std::vector<DigitPoint> points;
  for (std::size_t i = 0; i < postures.size() && !progress.stop(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(postures.size()), "postures");
    DigitPoint point;
    point.q = postures[i];
    if (net != nullptr) {
      point.rest = std::move(at_rest[i].rest);
      point.snapped = at_rest[i].snapped;
    }
    point.pull = tendons.pull(point.q, t, point.rest.x);
    point.tip = tip_force(tip_statics(tendons.digit(), point.q, t, point.pull), t);
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace thenar
