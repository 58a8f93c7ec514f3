#include "tendons/human/joint_strength.h"

namespace thenar {

TorqueLimits joint_strength(const Hand& tendons, const Eigen::VectorXd& q) {
  const Actuation actuation = tendons.actuation(q);
  return {actuation.B.cwiseMin(0) * actuation.upper, actuation.B.cwiseMax(0) * actuation.upper};
}

}  // namespace thenar
