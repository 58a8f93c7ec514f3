#include "tendons/digit_tendons.h"

namespace thenar {

Eigen::MatrixXd DigitTendons::torque_by_posture(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                                const TendonPull& at) const {
  if (TendonSlopes known = slopes(q, t); known.exist) return known.by_posture;
  constexpr double kStep = 1e-5;  // [rad]
  Eigen::MatrixXd slope(q.size(), q.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(q.size(), j);
    slope.col(j) =
        (pull(q + step, t, at.nodes).tau - pull(q - step, t, at.nodes).tau) / (2 * kStep);
  }
  return slope;
}

}  // namespace thenar
