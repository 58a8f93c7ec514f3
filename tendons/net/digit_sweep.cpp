#include "tendons/net/digit_sweep.h"

#include <utility>

#include "tendons/net/net_continuation.h"

namespace thenar {

std::vector<DigitPoint> sweep_digit(const DigitTendons& tendons,
                                    const std::vector<Eigen::VectorXd>& postures,
                                    const Eigen::VectorXd& t, const Progress& progress) {
  const auto* net = dynamic_cast<const NetTendons*>(&tendons);
  std::vector<DigitPoint> points;
  for (std::size_t i = 0; i < postures.size() && !progress.stop(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(postures.size()), "postures");
    DigitPoint point;
    point.q = postures[i];
    // Follow a net from the straight finger, or evaluate linear tendons.
    if (net != nullptr) {
      NetContinuation walk = follow_from_straight(*net, point.q, t);
      point.snapped = !walk.snaps.empty();
      point.rest = std::move(walk.rest);
      point.pull = net->torque_at_equilibrium(point.q, t, point.rest);
    } else {
      point.pull = tendons.evaluate(point.q, t);
    }
    // Compute the tip force at that torque.
    point.tip = tip_force(tip_statics(tendons.digit(), point.q, t, point.pull), t);
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace thenar
