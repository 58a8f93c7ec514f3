#pragma once

/// Tendons of a hand as an actuator with a state that continues from call to call.

#include <memory>
#include <vector>

#include "hand_versions/tendon_hand.h"
#include "tendons/net/tendon_actuator.h"

namespace thenar {

/// Torque of the tendons of a hand at a posture under tensions, and its derivatives.
struct [[nodiscard]] HandAction {
  TendonStatus status = TendonStatus::kValid;  // worst status of all digits: read this first
  bool snapped = false;    // true: a node of a net has jumped since the previous state
  bool slopes = true;      // true: B and K are complete; false: a digit lacks its derivatives
  Eigen::VectorXd tau;     // torque of the tendons, without passive joints [N m] (coordinates)
  Eigen::MatrixXd B;       // d tau/du [m/rad] (coordinates, actuators)
  Eigen::MatrixXd K;       // d tau/dq [N m/rad] (coordinates, coordinates)
  Eigen::VectorXd length;  // length of each actuator's line, up to a constant [m] (actuators)
  std::vector<const TendonAction*> digits;  // actions of the digits; null: a digit without muscles
};

/// Actuator of a hand: one TendonActuator per digit; a muscle of two digits adds the torques of
/// both. For one thread. Keeps a reference: the hand must outlive it.
class HandActuator {
 public:
  explicit HandActuator(const TendonHand& hand, const NetContinuationOptions& options = {});

  /// Moves the state to (q, u).
  /// @param q  posture [rad] (coordinates)
  /// @param u  tensions, each >= 0 [N] (actuators)
  /// @return action of the tendons there; overwritten by the next call
  /// @throws InputError if a length is wrong, or an entry negative or not finite.
  const HandAction& act(const Eigen::VectorXd& q, const Eigen::VectorXd& u);

  /// Forgets the state.
  void reset();

  /// Returns the actuator of one digit, whose nodes can be saved and restored; null: it has no
  /// muscles.
  [[nodiscard]] TendonActuator* digit(std::size_t i) { return digits_[i].get(); }

 private:
  const TendonHand& hand_;
  std::vector<std::unique_ptr<TendonActuator>> digits_;
  HandAction action_;
};

}  // namespace thenar
