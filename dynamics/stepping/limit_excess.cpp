#include "dynamics/stepping/limit_excess.h"

#include <algorithm>

namespace thenar {

void update_limit_excess(const Mechanism& mechanism, const MechanismLayout& layout,
                         const Eigen::VectorXd& q, Eigen::VectorXd& beyond) {
  if (beyond.size() == 0) beyond.setZero(static_cast<Eigen::Index>(mechanism.joints.size()));
  // Compare the excess of each hinge and slide with the largest so far.
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    if (!is_scalar(joint.kind)) continue;
    const double value = joint_value(joint, q[layout.first_q[i]]).value;
    double& max_excess = beyond[i];
    max_excess = std::max({max_excess, joint.lower - value, value - joint.upper});
  }
}

void keep_max_excess(const Eigen::VectorXd& other, Eigen::VectorXd& beyond) {
  if (beyond.size() == 0)
    beyond = other;
  else if (other.size() > 0)
    beyond = beyond.cwiseMax(other);
}

std::vector<PassedLimit> passed_limits(const Mechanism& mechanism, const Eigen::VectorXd& beyond) {
  std::vector<PassedLimit> out;
  for (Eigen::Index i = 0; i < beyond.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    const bool slides = joint.kind == JointKind::kSlide;
    if (beyond[i] > (slides ? kLimitLengthTolerance : kLimitAngleTolerance))
      out.push_back({joint.name, slides, beyond[i]});
  }
  return out;
}

}  // namespace thenar
