#include "tendons/net/posture_sweep.h"

#include "base/error.h"

namespace thenar {

std::vector<Eigen::VectorXd> postures_between(const Eigen::VectorXd& from,
                                              const Eigen::VectorXd& to, int steps) {
  require(steps > 0, "a sweep needs at least one step, got {}", steps);
  require(from.size() == to.size(), "postures have {} and {} angles", from.size(), to.size());
  std::vector<Eigen::VectorXd> postures;
  for (int k = 0; k <= steps; ++k) postures.emplace_back(from + (to - from) * k / steps);
  return postures;
}

Eigen::Matrix3Xd start_from_straight(const DigitTendons& tendons, const Eigen::VectorXd& q,
                                     const Eigen::VectorXd& t) {
  const auto* with_net = dynamic_cast<const NetTendons*>(&tendons);
  if (with_net == nullptr) return {};
  return follow_from_straight(*with_net, q, t).rest.x;
}

}  // namespace thenar
