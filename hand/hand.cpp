#include "hand/hand.h"

namespace thenar {

AppliedTorque Hand::applied_torque(const Eigen::VectorXd& q, const Eigen::VectorXd& u) const {
  Actuation actuation = this->actuation(q);
  return {actuation.B * u + actuation.tau_0, actuation.B, actuation.status, actuation.warning};
}

}  // namespace thenar
