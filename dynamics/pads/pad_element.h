#pragma once

/// Force element of a finger pad in a moving scene.

#include <array>
#include <memory>
#include <string>

#include "base/spatial.h"
#include "dynamics/stepping/force_element.h"
#include "pads/motion/moving_pad.h"

namespace thenar {

/// Tolerances of a PadElement.
struct PadElementOptions {
  double force_error = 0.05;  // largest error of the predicted push, over the pad's own push [1]
  double min_force = 0.05;    // push at or below which that error is relative to this force [N]
};

/// Pad on one body, pressed by another body and co-simulated with the scene.
///
/// Within a step the scene sees the predicted push
///   W(t) = integral of g(t - s) d(K x),
/// with the pad's stiffness K, the motion x of the object relative to the pad and the relaxation
/// function g of the pad. At the end of the step the pad model itself is solved. If the two pushes
/// differ by more than `force_error`, or the pad has no solution, the step is repeated with a
/// shorter length. The scene therefore sees a smooth force, and the pad is solved once per step. It
/// is not solved for a motion that changes the push by less than a fifth of the allowed error, over
/// less than 0.1 mm and 1 degree. K is updated when contact begins and after a poor prediction.
///
/// Steps below 50 us are accepted with any error: a push that changes so fast is taken for a jump.
/// If the pad has no solution even then, a fresh pad is pressed from outside to the present pose of
/// the object; while that fails it is retried every 5 ms, and the push is extrapolated with the
/// last K. A restart loses the states of friction and relaxation. add_action() returns false
/// meanwhile and in the step after a restart, which then count as unsolved. With a fixed step
/// length the pad follows the scene, whatever the error.
///
/// Before contact, a step is limited to the gap plus 0.2 mm of depth.
class PadElement final : public ForceElement {
 public:
  /// @param body   index of the body that carries the pad
  /// @param X_BP   pose of the pad in that body
  /// @param other  index of the body that presses on the pad; its frame is the object's frame
  /// @param pad    model of the pad, not yet in contact
  /// @throws InputError unless the options are positive and finite.
  PadElement(std::string name, int body, const Pose<double>& X_BP, int other,
             std::shared_ptr<const MovingPad> pad, const PadElementOptions& options = {});

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override;
  [[nodiscard]] std::string name() const override { return name_; }
  bool add_action(const ElementInput& at, ElementAction& out) override;
  [[nodiscard]] bool is_passive() const override { return true; }
  /// Returns the energy of the elastic pad E(x) and of its viscous memory [J]: with F = E' and the
  /// history terms H_i of the force (see MemoryStep),  E (g_inf + sum (H_i / F)^2 / g_i).  This is
  /// exact for springs with dampers, and for any pad immediately after loading and after a long
  /// rest.
  [[nodiscard]] double energy(const ElementInput& at) override;
  [[nodiscard]] double step_error(const ElementInput& at) override;
  void accept_step(const ElementInput& at) override;
  [[nodiscard]] double max_step_length() const override { return max_next_step_; }
  void add_contacts(const ElementInput& at, std::vector<ContactSample>& out) override;
  [[nodiscard]] bool may_start_motion(const ElementInput& at) const override;

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using PushMemory = std::array<ExponentialMemory, 6>;
  /// Predicted push of the object on the pad.
  struct Prediction {
    Vector6 push = Vector6::Zero();  // moment, force, pad's frame, about its origin [N m], [N] (6)
    double stiffness_ratio = 1;      // stiffness against a motion in this step, over K [1]
    double change = 0;         // change of the push since the pad moved, over allowed_error [1]
    double allowed_error = 1;  // largest error of the push [N]
  };
  /// Returns the pose X_PO of the object in the pad's frame.
  [[nodiscard]] Pose<double> object_pose(const ElementInput& at) const;
  /// Sets the Jacobian J_ of the object's velocity relative to the pad, at the pad's origin and
  /// along its axes: angular rows first.
  void set_motion_jacobian(const ElementInput& at);
  /// Returns a bound on the speed at which any point of the object approaches the pad [m/s].
  /// Requires set_motion_jacobian().
  [[nodiscard]] double approach_speed_bound(const ElementInput& at) const;
  [[nodiscard]] Prediction predict(double t, const Pose<double>& X_PO) const;
  /// Returns the size of a change of the push [N]: the larger of its force and of its moment about
  /// the contact patch over kMomentArm.
  [[nodiscard]] double equivalent_force(const Vector6& change) const;
  [[nodiscard]] bool is_negligible(const Prediction& predicted, const Pose<double>& X_PO) const;
  [[nodiscard]] bool has_valid_push() const { return !failure_.unsolved && !failure_.restarted; }
  /// Solves the pad for the object at X_PO at t, into trial_, without keeping the solution.
  void try_move(double t, const Pose<double>& X_PO, const Prediction& predicted);
  /// Moves the pad to the last accepted state if a motion to X_PO at t would otherwise be wrong by
  /// more than kNegligibleError of the allowed error.
  void move_to_accepted(double t, const Pose<double>& X_PO, double allowed_error);
  void keep_trial(bool new_stiffness);
  /// Replaces the pad by a fresh one that is pressed from outside to X_PO; on failure it sets the
  /// time of the next attempt.
  void restart_pad(double t, const Pose<double>& X_PO);
  /// Advances the memory of the push by an accepted step of the pad of this duration [s].
  void update_memory(double seconds);
  /// Computes the memory at t if the object moves to X_PO by then, linearly in time.
  [[nodiscard]] PushMemory memory_at(double t, const Pose<double>& X_PO) const;
  void advance_accepted(double t, const Pose<double>& X_PO);

  std::string name_;
  int body_, other_;
  Pose<double> X_BP_;
  std::shared_ptr<const MovingPad> origin_;  // untouched pad, from which clones are made
  std::unique_ptr<MovingPad> pad_;
  PadElementOptions options_;

  /// State of the pad after its last accepted step.
  struct KeptMove {
    double t = 0;        // time [s]
    Pose<double> X_PO;   // pose of the object
    PadContact contact;  // contact at that pose
    PushMemory memory;   // memory of the push [N m], [N]
  };
  /// State at the last accept_step(), which may be later than the last one of the pad.
  struct AcceptedState {
    double t = 0;       // time [s]
    Pose<double> X_PO;  // pose of the object
    PushMemory memory;  // memory of the push [N m], [N]
    double gap = 0;     // PadContact::gap of an object apart [m]
    double speed = 0;   // approach_speed_bound() of an object apart [m/s]
  };
  /// Move of the pad that is not kept yet.
  struct TrialMove {
    double t = -1;       // time [s]; -1: no trial
    Pose<double> X_PO;   // pose of the object
    PadContact contact;  // contact at that pose
    double error = 0;    // error of the predicted push, over the allowed error [1]
  };
  /// Status of a pad that had no solution.
  struct Failure {
    double retry_time = 0;   // earliest time of the next restart [s]
    bool restarted = false;  // flag: the pad was restarted in the last accept_step()
    bool unsolved = false;   // flag: the pad had no solution in the last accept_step()
  };
  KeptMove kept_;
  AcceptedState accepted_;
  TrialMove trial_;
  Failure failure_;
  Matrix6 stiffness_ = Matrix6::Zero();  // K, of the last update [N m], [N] over [rad], [m]
  double max_next_step_;                 // longest next step for which the push is valid [s]
  Eigen::MatrixXd J_;  // velocity of the object relative to the pad, transposed (v, 6)
};

}  // namespace thenar
