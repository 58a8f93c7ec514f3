#pragma once

/// A hand that is moved by its tendons, digit by digit, on whatever rung.

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
  double working_share = 0.2;               // of F0 at which a net is linearised, in (0, 1] [1]
};

/// A skeleton as a Hand with actuators that can only pull: u = tendon tensions, 0 <= u <= F0.
///
/// Digits with linear tendons:  B = R', tau_0 = passive joint torque. A floating net's torque is
/// not linear in the tensions; it is taken by its tangent at t* = working_share F0:
///   tau(t) = tau(t*) + R(t*)' (t - t*),  so  B = R(t*)',  tau_0 = tau(t*) - R(t*)' t* + passive.
/// Where a net finds no rest its slopes count all the same; trouble() tells.
/// A muscle that crosses joints of two digits is one actuator; its arms about one digit are those
/// with the other at its reference posture.
class TendonHand final : public Hand {
 public:
  /// @throws InputError if a digit has a coordinate that the skeleton lacks, a muscle no F0, or F0
  /// is not positive and finite; or as SkeletonHand.
  TendonHand(const Skeleton& skeleton, HandTendons tendons, std::vector<LinkSurface> surfaces = {},
             HandUse use = {});

  [[nodiscard]] const HandLayout& layout() const override { return layout_; }
  [[nodiscard]] std::vector<Pose<double>> pose(const Eigen::VectorXd& q) const override {
    return bones_.pose(q);
  }
  [[nodiscard]] Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(
      const Eigen::VectorXd& q, int link, const Eigen::Vector3d& p) const override {
    return bones_.jacobian(q, link, p);
  }
  [[nodiscard]] Actuation actuation(const Eigen::VectorXd& q) const override;
  [[nodiscard]] const std::vector<LinkSurface>& surfaces() const override {
    return bones_.surfaces();
  }

  /// What the tendons have to say at a posture; empty: nothing.
  [[nodiscard]] std::string trouble(const Eigen::VectorXd& q) const;

  /// Largest tensions (actuators) [N].
  [[nodiscard]] const Eigen::VectorXd& max_force() const { return max_force_; }

 private:
  /// Rows and columns of one digit within the hand.
  struct Place {
    std::vector<int> coordinates, actuators;
  };
  [[nodiscard]] TendonPull pull(std::size_t digit, const Eigen::VectorXd& q) const;

  SkeletonHand bones_;
  std::vector<std::unique_ptr<DigitTendons>> digits_;
  std::vector<Place> places_;
  Eigen::VectorXd max_force_;
  double working_share_;
  HandLayout layout_;
};

}  // namespace thenar
