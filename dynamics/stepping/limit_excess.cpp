#include "dynamics/stepping/limit_excess.h"

#include <algorithm>

namespace thenar {

void note_limits(const Mechanism& mechanism, const MechanismLayout& layout,
                 const Eigen::VectorXd& q, Eigen::VectorXd& beyond) {
  if (beyond.size() == 0) beyond.setZero(static_cast<Eigen::Index>(mechanism.joints.size()));
  // Hinges and slides: largest way beyond a limit so far.
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    if (!is_scalar(joint.kind)) continue;
    const double value = joint_value(joint, q[layout.first_q[i]]).value;
    double& most = beyond[static_cast<Eigen::Index>(i)];
    most = std::max({most, joint.lower - value, value - joint.upper});
  }
}

void keep_larger(const Eigen::VectorXd& other, Eigen::VectorXd& beyond) {
  if (beyond.size() == 0)
    beyond = other;
  else if (other.size() > 0)
    beyond = beyond.cwiseMax(other);
}

std::vector<PassedLimit> passed_limits(const Mechanism& mechanism, const Eigen::VectorXd& beyond) {
  std::vector<PassedLimit> out;
  for (Eigen::Index i = 0; i < beyond.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[static_cast<std::size_t>(i)];
    const bool slides = joint.kind == JointKind::kSlide;
    if (beyond[i] > (slides ? kAtLimitWay : kAtLimitTurn))
      out.push_back({joint.name, slides, beyond[i]});
  }
  return out;
}

}  // namespace thenar
