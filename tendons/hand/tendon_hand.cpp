#include "tendons/hand/tendon_hand.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

TorqueLimits no_motors(const Skeleton& skeleton) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(skeleton.coordinates());
  return {zero, zero};
}

/// Index of a name, or the size if it is not there.
int place_of(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace

TendonHand::TendonHand(const Skeleton& skeleton, HandTendons tendons,
                       std::vector<LinkSurface> surfaces, HandUse use)
    : bones_(skeleton, no_motors(skeleton), std::move(surfaces), std::move(use)),
      digits_(std::move(tendons.digits)),
      working_share_(tendons.working_share),
      layout_(bones_.layout()) {
  require(working_share_ > 0 && working_share_ <= 1, "share of F0 must be in (0, 1], got {}",
          working_share_);
  layout_.actuators.clear();
  std::vector<double> force;
  for (const auto& tendons_of : digits_) {
    const TendonNames& names = tendons_of->digit().names;
    Place place;
    for (const std::string& name : names.coordinates) {
      place.coordinates.push_back(place_of(layout_.coordinates, name));
      require(place.coordinates.back() < skeleton.coordinates(),
              "tendons move joint '{}', which the hand lacks", name);
    }
    for (const std::string& name : names.muscles) {
      place.actuators.push_back(place_of(layout_.actuators, name));
      if (place.actuators.back() < static_cast<int>(force.size())) continue;
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

TendonPull TendonHand::pull(std::size_t digit, const Eigen::VectorXd& q) const {
  const Place& place = places_[digit];
  return digits_[digit]->pull(q(place.coordinates), working_share_ * max_force_(place.actuators));
}

Actuation TendonHand::actuation(const Eigen::VectorXd& q) const {
  Actuation actuation = bones_.actuation(q);  // tau_0 has the passive torque
  const Eigen::Index m = max_force_.size();
  actuation.B = Eigen::MatrixXd::Zero(q.size(), m);
  actuation.lower = Eigen::VectorXd::Zero(m);
  actuation.upper = max_force_;
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    const Place& place = places_[i];
    if (place.actuators.empty()) continue;  // a digit without muscles
    const TendonPull here = pull(i, q);
    const Eigen::VectorXd t = working_share_ * max_force_(place.actuators);
    const Eigen::VectorXd rest = here.tau - here.R.transpose() * t;
    for (std::size_t row = 0; row < place.coordinates.size(); ++row) {
      const auto r = static_cast<Eigen::Index>(row);
      actuation.tau_0[place.coordinates[row]] += rest[r];
      for (std::size_t column = 0; column < place.actuators.size(); ++column)
        actuation.B(place.coordinates[row], place.actuators[column]) +=
            here.R(static_cast<Eigen::Index>(column), r);
    }
  }
  return actuation;
}

std::string TendonHand::trouble(const Eigen::VectorXd& q) const {
  (void)bones_.pose(q);  // refuses a posture of the wrong length
  std::string all;
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    if (places_[i].actuators.empty()) continue;
    const std::string one = pull(i, q).trouble;
    if (!one.empty()) all += (all.empty() ? "" : "; ") + one;
  }
  return all;
}

}  // namespace thenar
