#include "hand_versions/tendon_hand.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/lists.h"
#include "hand_versions/hand_actuator.h"

namespace thenar {
namespace {

/// Returns zero torque limits.
TorqueLimits no_motors(const Skeleton& skeleton) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(skeleton.coordinates());
  return {zero, zero};
}

}  // namespace

TendonHand::TendonHand(const Skeleton& skeleton, HandTendons tendons,
                       std::vector<LinkSurface> surfaces, ClosingSynergy use)
    : bones_(skeleton, no_motors(skeleton), std::move(surfaces), std::move(use)),
      digits_(std::move(tendons.digits)),
      working_share_(tendons.working_share),
      layout_(bones_.layout()) {
  require(working_share_ > 0 && working_share_ <= 1, "share of F0 must be in (0, 1], got {}",
          working_share_);
  layout_.actuators.clear();
  std::vector<double> force;
  // Find the rows and columns of each digit within the hand.
  for (const auto& tendons_of : digits_) {
    const TendonNames& names = tendons_of->digit().names;
    Place place;
    for (const std::string& name : names.coordinates) {
      place.coordinates.push_back(place_in(layout_.coordinates, name));
      require(place.coordinates.back() >= 0, "tendons move joint '{}', which the hand lacks", name);
    }
    // Use one actuator for a muscle that two digits share.
    for (const std::string& name : names.muscles) {
      const int known = place_in(layout_.actuators, name);
      place.actuators.push_back(known >= 0 ? known : static_cast<int>(force.size()));
      if (known >= 0) continue;
      const auto found = tendons.max_force.find(name);
      require(found != tendons.max_force.end(), "no largest tension for muscle '{}'", name);
      require(found->second > 0 && std::isfinite(found->second),
              "largest tension of muscle '{}' must be > 0 N, got {}", name, found->second);
      layout_.actuators.push_back(name);
      force.push_back(found->second);
    }
    places_.push_back(place);
  }
  max_force_ = Eigen::Map<const Eigen::VectorXd>(force.data(), static_cast<int>(force.size()));
}

namespace {

/// Converts the status of tendons.
ActuationStatus status_of(TendonStatus status) {
  if (status == TendonStatus::kValid || status == TendonStatus::kApproximate)
    return ActuationStatus::kExact;
  return status < TendonStatus::kInvalidPath ? ActuationStatus::kDoubtful
                                             : ActuationStatus::kUnbalanced;
}

/// Continuation options for a single posture: long steps, in which small snaps on the way are not
/// detected.
constexpr NetContinuationOptions kHandContinuation{2e-3};

/// Digit of a hand at a posture, its tendons as a secant.
struct DigitSecant {
  Eigen::MatrixXd B;      // (coordinates, actuators)
  Eigen::VectorXd tau_0;  // [N m] (coordinates)
  ActuationStatus status;
  std::string warning;
};

/// Computes the secant of one digit between zero tension and t.
DigitSecant secant(const DigitTendons& tendons, const Eigen::VectorXd& q,
                   const Eigen::VectorXd& t) {
  // Return the arms of linear tendons.
  const auto* net = dynamic_cast<const NetTendons*>(&tendons);
  if (net == nullptr) {
    const TendonTorque pull = tendons.evaluate(q, t);
    return {pull.R.transpose(), Eigen::VectorXd::Zero(q.size()), status_of(pull.status),
            pull.warning};
  }
  // Evaluate a net without tension and at the working tension.
  TendonActuator slackened(tendons, kHandContinuation), pulled(tendons, kHandContinuation);
  const TendonAction& at = pulled.act(q, t);
  const TendonAction& slack = slackened.act(q, Eigen::VectorXd::Zero(t.size()));
  DigitSecant out{at.R.transpose(), slack.tau, status_of(at.status), at.warning};
  if (out.status == ActuationStatus::kExact) out.status = ActuationStatus::kLinearised;
  // Correct B through the muscles that pull the net.
  const Eigen::VectorXd pulls = net->shares().colwise().sum().transpose();
  const Eigen::VectorXd w = (pulls.array() > 0).select(t, 0);
  if (w.squaredNorm() > 0)
    out.B += (at.tau - slack.tau - out.B * t) * w.transpose() / w.squaredNorm();
  return out;
}

/// Combines a status and a warning with those so far.
void combine_status(ActuationStatus status, const std::string& warning, ActuationStatus& worst,
                    std::string& all) {
  worst = std::max(worst, status);
  if (!warning.empty()) all += (all.empty() ? "" : "; ") + warning;
}

}  // namespace

Actuation TendonHand::actuation(const Eigen::VectorXd& q) const {
  Actuation actuation = bones_.actuation(q);  // tau_0 has the passive torque
  const Eigen::Index m = max_force_.size();
  // Set one actuator for each muscle, which can only pull.
  actuation.B = Eigen::MatrixXd::Zero(q.size(), m);
  actuation.lower = Eigen::VectorXd::Zero(m);
  actuation.upper = max_force_;
  // Add each digit in its rows and columns.
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    const Place& place = places_[i];
    if (place.actuators.empty()) continue;  // a digit without muscles
    const DigitSecant here =
        secant(*digits_[i], q(place.coordinates), working_share_ * max_force_(place.actuators));
    combine_status(here.status, here.warning, actuation.status, actuation.warning);
    actuation.tau_0(place.coordinates) += here.tau_0;
    actuation.B(place.coordinates, place.actuators) += here.B;
  }
  return actuation;
}

AppliedTorque TendonHand::applied_torque(const Eigen::VectorXd& q, const Eigen::VectorXd& u) const {
  HandActuator actuator(*this, kHandContinuation);
  // Compute the exact torque, with the worst status of the digits.
  const HandAction& action = actuator.act(q, u);
  AppliedTorque effort{action.tau + passive(q), action.B, ActuationStatus::kExact, ""};
  for (const TendonAction* digit : action.digits)
    if (digit != nullptr)
      combine_status(status_of(digit->status), digit->warning, effort.status, effort.warning);
  return effort;
}

TorqueLimits joint_torque_limits(const Hand& tendons, const Eigen::VectorXd& q) {
  const Actuation actuation = tendons.actuation(q);
  return {actuation.B.cwiseMin(0) * actuation.upper, actuation.B.cwiseMax(0) * actuation.upper};
}

}  // namespace thenar
