#include "grasp/closing/tendon_closing.h"

#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

using Free = Eigen::Array<bool, Eigen::Dynamic, 1>;

void require_pull(const HandLayout& layout, const ClosingTensions& pull, const Free& free) {
  const auto n = static_cast<Eigen::Index>(layout.coordinates.size());
  require(pull.u.size() == static_cast<Eigen::Index>(layout.actuators.size()) &&
              pull.stiffness.size() == n && free.size() == n,
          "a hand of {} coordinates and {} actuators, but {} stiffnesses, {} marks and {} tensions",
          n, layout.actuators.size(), pull.stiffness.size(), free.size(), pull.u.size());
  require(pull.u.allFinite() && (pull.u.array() >= 0).all(), "tendons cannot push");
  require(pull.stiffness.allFinite() && (pull.stiffness.array() > 0).all(),
          "joints must have positive stiffness");
  require(std::isfinite(pull.excursion), "an excursion must be finite, got {} m/s", pull.excursion);
}

/// Sums the tensions of tendons that act on any joint of the drive [N].
double sum_of_tensions(const Drive& drive, const Eigen::MatrixXd& B, const Eigen::VectorXd& u) {
  double sum = 0;
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    const auto crosses = [&](const DrivenCoordinate& each) { return B(each.coordinate, i) != 0; };
    if (any_of(drive.moves, crosses)) sum += u[i];
  }
  return sum;
}

}  // namespace

Eigen::VectorXd tendon_rates(const Hand& hand, const ClosingTensions& pull,
                             const Eigen::VectorXd& q, const Free& free) {
  const HandLayout& layout = hand.layout();
  require_pull(layout, pull, free);
  // Torques of the tendons at this posture.
  const Eigen::MatrixXd B = hand.applied_torque(q, pull.u).B;
  const Eigen::VectorXd torque = B * pull.u;
  Eigen::VectorXd rates = Eigen::VectorXd::Zero(q.size());
  // Each drive, with its joints in the ratio of torque over stiffness.
  for (const Drive& drive : layout.drives) {
    if (drive.speed == 0) continue;
    double power = 0;  // power of the tensions while joints turn by torque over stiffness [W]
    for (const DrivenCoordinate& driven : drive.moves) {
      const Eigen::Index j = driven.coordinate;
      if (free[j] && torque[j] > 0) power += torque[j] * torque[j] / pull.stiffness[j];
    }
    if (power == 0) continue;
    // Scale the rates so that the tendons shorten at the speed of the drive.
    const double scale = pull.excursion * drive.speed * sum_of_tensions(drive, B, pull.u) / power;
    for (const DrivenCoordinate& driven : drive.moves) {
      const Eigen::Index j = driven.coordinate;
      if (free[j] && torque[j] > 0) rates[j] = scale * torque[j] / pull.stiffness[j];
    }
  }
  return rates;
}

ClosingRates tendon_closing_rates(const Hand& hand, Eigen::VectorXd pull) {
  const auto n = static_cast<Eigen::Index>(hand.layout().coordinates.size());
  ClosingTensions all{std::move(pull), Eigen::VectorXd::Ones(n)};
  require_pull(hand.layout(), all, Free::Constant(n, true));
  require((all.u.array() > 0).any(), "no tendon of the hand pulls");
  // The function keeps a reference to the hand, as the header says.
  return [&hand, all](const Eigen::VectorXd& q, const Free& free) {
    return tendon_rates(hand, all, q, free);
  };
}

}  // namespace thenar
