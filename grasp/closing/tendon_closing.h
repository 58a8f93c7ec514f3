#pragma once

/// Rates at which tendons close the fingers of a hand.

#include <Eigen/Core>

#include "grasp/closing/close_hand.h"
#include "hand/hand.h"

namespace thenar {

/// Tensions of tendons that close a hand, and the stiffness of its joints.
struct ClosingTensions {
  Eigen::VectorXd u;  // tension of each actuator, >= 0 [N] (actuators)
  /// Stiffness of each joint, > 0; only ratios matter [N m/rad] (coordinates).
  Eigen::VectorXd stiffness;
  double excursion = 0.01;  // excursion rate of tendons of a drive of speed 1, weighted by u [m/s]
};

/// Computes the rates of coordinates under rising tension at a posture. A free coordinate turns by
///   dq = K^-1 B u,
/// scaled for each drive so that its tendons shorten at  u' B' dq / |u|_1 = excursion Drive::speed,
/// |u|_1 over the tendons that act on the drive; B of Hand::applied_torque() at (q, u). Where
/// torque is linear in tensions, only their ratios matter. A blocked joint takes no excursion, so
/// that the others of its drive turn faster, in the same ratio. Joints that the tendons would
/// extend do not move: K represents their resistance. Neither do drives of speed 0.
/// @param q  (coordinates) [rad];  @param free  whether a drive may still move each (coordinates)
/// @return q_dot (coordinates) [rad/s]
/// @throws InputError if a length is wrong, u is negative, or a stiffness not positive.
[[nodiscard]] Eigen::VectorXd tendon_rates(const Hand& hand, const ClosingTensions& pull,
                                           const Eigen::VectorXd& q,
                                           const Eigen::Array<bool, Eigen::Dynamic, 1>& free);

/// Binds tendon_rates() for CloseOptions::rates. All joints are equally stiff (an assumption: most
/// subjects state no joint stiffness), and tendons of a drive of speed 1 shorten at 10 mm/s. The
/// hand must outlive the result.
/// @param pull  tension of each actuator [N] (actuators); for human hands max_flexor_tensions() of
///   hand_versions/closing_synergy.h
/// @throws InputError if the length is wrong, a tension negative, or all are zero.
[[nodiscard]] ClosingRates tendon_closing_rates(const Hand& hand, Eigen::VectorXd pull);

}  // namespace thenar
