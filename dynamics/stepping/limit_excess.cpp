#include "dynamics/stepping/limit_excess.h"

#include <algorithm>

namespace thenar {

void update_limit_excess(const Mechanism& mechanism, const MechanismLayout& layout,
                         const Eigen::VectorXd& q, Eigen::VectorXd& excess) {
  if (excess.size() == 0) excess.setZero(static_cast<Eigen::Index>(mechanism.joints.size()));
  // Compare the excess of each hinge and slide with the largest so far.
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    if (!is_scalar(joint.kind)) continue;
    const double value = joint_value(joint, q[layout.first_q[i]]).value;
    double& max_excess = excess[i];
    max_excess = std::max({max_excess, joint.lower - value, value - joint.upper});
  }
}

void keep_max_excess(const Eigen::VectorXd& other, Eigen::VectorXd& excess) {
  if (excess.size() == 0)
    excess = other;
  else if (other.size() > 0)
    excess = excess.cwiseMax(other);
}

std::vector<PassedLimit> passed_limits(const Mechanism& mechanism, const Eigen::VectorXd& excess) {
  std::vector<PassedLimit> out;
  for (Eigen::Index i = 0; i < excess.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    const bool slides = joint.kind == JointKind::kSlide;
    if (excess[i] > (slides ? kLimitLengthTolerance : kLimitAngleTolerance))
      out.push_back({joint.name, slides, excess[i]});
  }
  return out;
}

}  // namespace thenar
