#pragma once

/// All tendons of a hand as an actuator: a state that continues from call to call.

#include <memory>
#include <vector>

#include "hand_versions/tendon_hand.h"
#include "tendons/net/tendon_actuator.h"

namespace thenar {

/// Torque of the tendons of a hand at a posture under tensions, and its derivatives.
struct [[nodiscard]] HandAction {
  TendonStatus status = TendonStatus::kValid;  // the worst of all digits: read this first
  bool snapped = false;                        // a knot of a net has jumped since the state before
  bool slopes = true;                          // all digits have theirs; else B and K lack them
  Eigen::VectorXd tau;     // of the tendons, without passive joints [N m] (coordinates)
  Eigen::MatrixXd B;       // d tau/du [m/rad] (coordinates, actuators)
  Eigen::MatrixXd K;       // d tau/dq [N m/rad] (coordinates, coordinates)
  Eigen::VectorXd length;  // of each actuator's line but for a constant [m] (actuators)
  std::vector<const TendonAction*> digits;  // parts; null: a digit without muscles
};

/// One TendonActuator for each digit; a muscle of two digits adds both.
/// For one thread. Keeps a reference: the hand must outlive it.
class HandActuator {
 public:
  explicit HandActuator(const TendonHand& hand, const NetContinuationOptions& options = {});

  /// Moves the state to (q, u).
  /// @param q  (coordinates) [rad];  @param u  tensions, each >= 0 [N] (actuators)
  /// @return what the tendons do there; overwritten by the next call
  /// @throws InputError if a length is wrong, or an entry negative or not finite.
  const HandAction& act(const Eigen::VectorXd& q, const Eigen::VectorXd& u);

  /// Forgets the state.
  void reset();

  /// Returns the actuator of one digit, to keep its nodes or continue from others; null: it has no
  /// muscles.
  [[nodiscard]] TendonActuator* digit(std::size_t i) { return digits_[i].get(); }

 private:
  const TendonHand& hand_;
  std::vector<std::unique_ptr<TendonActuator>> digits_;
  HandAction action_;
};

}  // namespace thenar
