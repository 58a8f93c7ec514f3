#pragma once

/// Hand moved by its tendons, digit by digit, with any tendon model.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hand/skeleton_hand.h"
#include "tendons/digit_tendons.h"

namespace thenar {

/// Tendons of a whole hand.
struct HandTendons {
  std::vector<std::unique_ptr<DigitTendons>> digits;
  std::map<std::string, double> max_force;  // F0 of every muscle of the digits [N]
  double working_share = 0.2;  // tension over F0 at which a net is linearised, in (0, 1] [1]
};

/// Skeleton as a Hand with actuators that can only pull: u = tendon tensions, 0 <= u <= F0.
///
/// Digits with linear tendons:  B = R', tau_0 = passive joint torque. A floating net's torque
/// tau(t) is not linear in the tensions. actuation() uses the secant through zero tension and t* =
/// working_share F0 that is nearest to the tangent R at t*:
///   tau_0 = tau(0) + passive,   B = R(t*)' + (tau(t*) - tau(0) - R(t*)' t*) w' / (w' t*),
/// where w is t* for the muscles that pull the net and 0 for others: exact at both tensions.
/// applied_torque() is exact everywhere. Nets are followed from the straight finger as in
/// TendonActuator, so both agree with `thenar tendon solve`. Where a net finds no equilibrium the
/// status says so. Both are for single postures; for a sequence of postures use a HandActuator. A
/// muscle that crosses joints of two digits is one actuator; its arms about one digit are those
/// with the other at its reference posture.
class TendonHand final : public Hand {
 public:
  /// Builds the hand.
  /// @throws InputError if a digit has a coordinate that the skeleton lacks, a muscle has no F0, or
  /// F0 is not positive and finite; or as SkeletonHand.
  TendonHand(const Skeleton& skeleton, HandTendons tendons, std::vector<LinkSurface> surfaces = {},
             ClosingSynergy use = {});

  [[nodiscard]] const HandLayout& layout() const override { return layout_; }
  [[nodiscard]] std::vector<Pose<double>> pose(const Eigen::VectorXd& q) const override {
    return bones_.pose(q);
  }
  [[nodiscard]] Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(
      const Eigen::VectorXd& q, int link, const Eigen::Vector3d& p) const override {
    return bones_.jacobian(q, link, p);
  }
  [[nodiscard]] Actuation actuation(const Eigen::VectorXd& q) const override;
  /// @param u  tensions, each >= 0 [N] (actuators)
  /// @throws InputError if a length is wrong, or a tension negative or not finite.
  [[nodiscard]] AppliedTorque applied_torque(const Eigen::VectorXd& q,
                                             const Eigen::VectorXd& u) const override;
  [[nodiscard]] const std::vector<LinkSurface>& surfaces() const override {
    return bones_.surfaces();
  }

  /// Returns the largest tensions (actuators) [N].
  [[nodiscard]] const Eigen::VectorXd& max_force() const { return max_force_; }

  /// Rows and columns of one digit within the hand.
  struct Place {
    std::vector<int> coordinates, actuators;
  };
  [[nodiscard]] const std::vector<std::unique_ptr<DigitTendons>>& digits() const { return digits_; }
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }

  /// Computes the torque of passive joints [N m] (coordinates).
  [[nodiscard]] Eigen::VectorXd passive(const Eigen::VectorXd& q) const {
    return bones_.actuation(q).tau_0;
  }

 private:
  SkeletonHand bones_;
  std::vector<std::unique_ptr<DigitTendons>> digits_;
  std::vector<Place> places_;
  Eigen::VectorXd max_force_;
  double working_share_;
  HandLayout layout_;
};

// Torque limits of a hand of motors, from tendons.

/// Computes the largest and smallest torque of each coordinate at posture q,
///   upper_j = sum_i max(B_ji, 0) upper_i,   lower_j = sum_i min(B_ji, 0) upper_i,
/// the bounds of each joint's torque if it alone mattered, without passive torque. A hand of motors
/// with these limits can exert at least as much torque, as its joints do not share muscles.
/// @param tendons  hand whose smallest tensions are 0
[[nodiscard]] TorqueLimits joint_torque_limits(const Hand& tendons, const Eigen::VectorXd& q);

}  // namespace thenar
