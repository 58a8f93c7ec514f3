#include "hand_versions/hand_actuator.h"

#include "base/error.h"

namespace thenar {

HandActuator::HandActuator(const TendonHand& hand, const NetContinuationOptions& options)
    : hand_(hand) {
  for (std::size_t i = 0; i < hand.digits().size(); ++i) {
    const bool pulled = !hand.places()[i].actuators.empty();
    digits_.push_back(pulled ? std::make_unique<TendonActuator>(*hand.digits()[i], options)
                             : nullptr);
  }
}

const HandAction& HandActuator::act(const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
  const auto n = static_cast<Eigen::Index>(hand_.layout().coordinates.size());
  const Eigen::Index m = hand_.max_force().size();
  require(q.size() == n && u.size() == m, "wanted {} angles and {} tensions, got {} and {}", n, m,
          q.size(), u.size());
  // Reset the action.
  action_.status = TendonStatus::kValid;
  action_.snapped = false;
  action_.slopes = true;
  action_.tau.setZero(n);
  action_.B.setZero(n, m);
  action_.K.setZero(n, n);
  action_.length.setZero(m);
  action_.digits.assign(digits_.size(), nullptr);
  // Add each digit to its rows and columns.
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    if (!digits_[i]) continue;
    const auto& [rows, columns] = hand_.places()[i];
    const TendonAction& part = digits_[i]->act(q(rows), u(columns));
    action_.digits[i] = &part;
    action_.status = worse(action_.status, part.status);
    action_.snapped = action_.snapped || part.snapped;
    action_.slopes = action_.slopes && part.slopes;
    action_.tau(rows) += part.tau;
    action_.B(rows, columns) += part.R.transpose();
    // Add derivatives where they exist.
    if (!part.slopes) continue;
    action_.K(rows, rows) += part.K;
    action_.length(columns) += part.length;
  }
  return action_;
}

void HandActuator::reset() {
  for (const auto& digit : digits_)
    if (digit) digit->reset();
}

}  // namespace thenar
