#pragma once

/// Tendons of one digit as an actuator with a state that continues from call to call.
///
/// Cost of a call: docs/theory/extensor_net.md, section "As an actuator".

#include "tendons/net/net_continuation.h"

namespace thenar {

/// Torque of tendons at a posture under tensions, and its derivatives.
struct [[nodiscard]] TendonAction {
  TendonStatus status = TendonStatus::kUnbalanced;  // worst status of all parts: read this first
  TendonStatus paths = TendonStatus::kValid;        // status of tendons outside a net
  TendonStatus hood = TendonStatus::kValid;         // status of the net; kValid without one
  double residual = 0;   // largest out-of-balance force of a floating node [N]
  bool snapped = false;  // true: a floating node has jumped since the previous state
  bool slopes = false;  // true: R, K and length are complete; false: some derivatives do not exist,
                        // R may lack the net, K and length are incomplete or empty
  Eigen::VectorXd tau;  // joint torque of the tendons [N m] (coordinates)
  Eigen::MatrixXd R;  // moment arms, transpose of d tau / d tension [m/rad] (muscles, coordinates)
  Eigen::MatrixXd K;  // d tau/dq at constant tensions, so MINUS the joint stiffness of the tendons
                      // [N m/rad] (coordinates, coordinates)
  Eigen::VectorXd length;  // length of each muscle's line, up to a constant; positive changes are
                           // positive excursions [m] (muscles)
  SlipTension slips;       // zero without a hood
  std::string warning;     // explanation of `status`, in words
};

/// Actuator of one digit, at any level of detail. Here t are tendon tensions, not time, and no
/// derivative is a rate in time. Torque is exact at (q, t): without tension it is that of the net's
/// own bands alone. With E* the potential energy of bands and tensions in the equilibrium of the
/// net, a muscle that pulls on a net has the length
///   dE*/d tension = sum of the lengths of its bands + those of its own paths,
/// so that  d length/dq = -R  at constant tensions (envelope theorem).
///
/// The first call, and the first after reset(), starts from the straight finger as
/// follow_from_straight() does, and so finds the result of `thenar tendon solve`. Later calls start
/// from the previous state, moved by its derivatives; where the equilibrium differs from this
/// prediction by more than NetContinuationOptions::stray the step is halved, so that a long step
/// gives the same result as many short ones. For one thread. Keeps a reference: the tendons must
/// outlive it.
class TendonActuator {
 public:
  explicit TendonActuator(const DigitTendons& tendons, const NetContinuationOptions& options = {});

  /// Moves the state to (q, t).
  /// @param q  posture [rad] (coordinates)
  /// @param t  tendon tensions, each >= 0 [N] (muscles)
  /// @return action of the tendons there; overwritten by the next call
  /// @throws InputError as DigitTendons::evaluate()
  const TendonAction& act(const Eigen::VectorXd& q, const Eigen::VectorXd& t);

  /// Returns the nodes of the net in the present state; empty: none, or no state yet [m] (3,
  /// nodes).
  [[nodiscard]] const Eigen::Matrix3Xd& nodes() const { return rest_.x; }

  /// Sets the state to the equilibrium reached from these nodes at (q, t), whatever the previous
  /// state: to continue from a saved one. @throws InputError as DigitTendons::evaluate()
  const TendonAction& start_at(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                               const Eigen::Matrix3Xd& nodes);

  /// Forgets the state.
  void reset() { known_ = false; }

  /// Returns the number of snaps since the actuator was built.
  [[nodiscard]] int snaps() const { return snaps_; }

 private:
  void move_net(const Eigen::VectorXd& q, const Eigen::VectorXd& t);
  void add_net(const Eigen::VectorXd& q, const Eigen::VectorXd& t);
  void evaluate_outside(const Eigen::VectorXd& q, const Eigen::VectorXd& t);

  const DigitTendons& tendons_;
  const NetTendons* net_;  // tendons_ as a digit with a net; null: it has none
  NetContinuationOptions options_;
  TendonAction action_;
  bool known_ = false;          // true: there is a state, as follows
  Eigen::VectorXd q_, t_;       // posture [rad], tensions [N]
  NetEquilibrium rest_;         // equilibrium of the net
  Eigen::MatrixXd by_posture_;  // derivative of its nodes, stacked (3 nodes, coordinates) [m/rad]
  int snaps_ = 0;
};

}  // namespace thenar
