#pragma once

/// Finger pads in a moving scene.

#include <array>
#include <memory>
#include <string>

#include "base/spatial.h"
#include "dynamics/stepping/force_element.h"
#include "pads/motion/moving_pad.h"

namespace thenar {

struct PadElementOptions {
  double force_error = 0.05;  // of the push in a step, against that of the pad itself [1]
  double least_force = 0.05;  // errors of smaller pushes are measured by this one [N]
};

/// A pad on a body, against another body, co-simulated: in a step the scene sees the push as
///   W(t) = integral of g(t - s) d(K x),
/// with the pad's stiffness K at the last accept_step(), the object's motion x against the pad, and
/// the pad's relaxation g; where a step ends, the pad itself is asked. If both differ by more than
/// `force_error`, or the pad has no answer, the step is made again, shorter. So the scene sees a
/// smooth force, and the pad moves once a step. Motions that change a push by less than a fifth of
/// the allowed error, over less than 0.1 mm and 1 degree, do not move it.
///
/// Steps of less than 50 us are not made shorter for it: a push that jumps in that time jumps by
/// itself. If a pad has no answer even so, the object is brought in again from outside at once,
/// and failing that every 5 ms, while the last push goes on by its stiffness. Friction and
/// relaxation are forgotten then, and add_action() fails for a step, so that it counts as unsolved.
/// In steps of fixed length the pad follows, whatever the error.
///
/// Before they touch, a step goes no farther than the object is away, and 0.2 mm into the pad.
class PadElement final : public ForceElement {
 public:
  /// @param body   that carries the pad, X_BP its pose there
  /// @param other  that presses on it; the object's frame is the body's
  /// @param pad    that nothing has touched yet
  /// @throws InputError unless options are positive and finite.
  PadElement(std::string name, int body, const Pose<double>& X_BP, int other,
             std::shared_ptr<const MovingPad> pad, const PadElementOptions& options = {});

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override;
  [[nodiscard]] std::string name() const override { return name_; }
  bool add_action(const ElementInput& at, ElementAction& out) override;
  [[nodiscard]] bool is_passive() const override { return true; }
  /// Returns the energy of the elastic pad E(x) and of its viscous memory: with F = E' and H_i of
  /// the force as in MemoryStep,  E (g_inf + sum (H_i / F)^2 / g_i), which is exact for springs
  /// with dampers, and for any pad at once and after a long rest.
  [[nodiscard]] double energy(const ElementInput& at) override;
  [[nodiscard]] double step_error(const ElementInput& at) override;
  void accept_step(const ElementInput& at) override;
  [[nodiscard]] double max_step_length() const override { return foresees_; }
  void add_contacts(const ElementInput& at, std::vector<ContactSample>& out) override;
  [[nodiscard]] bool may_start_motion(const ElementInput& at) const override;

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using PushMemory = std::array<ExponentialMemory, 6>;
  /// Predicted push of the pad on the scene.
  struct Prediction {
    Vector6 push;        // pad's frame, about its origin (6)
    double share = 1;    // of K that a motion in this step feels [1]
    double change = 0;   // of the push since the pad moved, over what is allowed [1]
    double allowed = 1;  // error of the push [N]
  };
  [[nodiscard]] Pose<double> object_pose(const ElementInput& at) const;
  /// Rows of the speeds of the object against the pad, at its origin, along its axes: turns, ways.
  void set_rows(const ElementInput& at);
  /// A bound on the speed at which any point of the object comes nearer to the pad [m/s]; needs
  /// set_rows().
  [[nodiscard]] double fastest(const ElementInput& at) const;
  [[nodiscard]] Prediction predict(double t, const Pose<double>& X_PO) const;
  /// Size of a change of the push: moments about the patch by a lever of half a fingertip [N].
  [[nodiscard]] double size_of(const Vector6& change) const;
  [[nodiscard]] bool changed_little(const Prediction& seen, const Pose<double>& X_PO) const;
  [[nodiscard]] bool has_answer() const { return !lost_.stale && !lost_.anew; }
  void try_move(double t, const Pose<double>& X_PO, const Prediction& seen);
  /// Moves the pad to the last accept_step(), before a motion to X_PO at t that needs it.
  void catch_up(double t, const Pose<double>& X_PO, double allowed);
  void keep_move(bool new_stiffness);
  void begin_anew(double t, const Pose<double>& X_PO);
  /// The memory takes up the push of the pad, which has moved for some time; or goes on without it.
  void remember_push(double seconds);
  /// Computes the memory at t, if the object moves to X_PO by then, linearly in time.
  [[nodiscard]] PushMemory memory_at(double t, const Pose<double>& X_PO) const;
  void go_on(double t, const Pose<double>& X_PO);

  std::string name_;
  int body_, other_;
  Pose<double> X_BP_;
  std::shared_ptr<const MovingPad> origin_;  // that clones come from
  std::unique_ptr<MovingPad> pad_;
  PadElementOptions options_;

  /// The pad at its last move that was kept.
  struct Kept {
    double t = 0;       // [s]
    Pose<double> X_PO;  // of the object
    PadContact touch;
    PushMemory memory;  // of the push [N m], [N]
  };
  /// The last accept_step(), which may be later than the pad's move.
  struct Accepted {
    double t = 0;               // to which the memory has come [s]
    Pose<double> X_PO;          // of the object
    PushMemory memory;          // of the push [N m], [N]
    double gap = 0, speed = 0;  // of the object apart: PadContact, fastest()
  };
  /// A move of the pad that is not kept yet.
  struct Trial {
    double t = -1;
    Pose<double> X_PO;
    PadContact touch;
    double error = 0;  // of the prediction, over what is allowed [1]
  };
  /// A pad without an answer.
  struct Lost {
    double retry = 0;    // when it may begin anew [s]
    bool anew = false;   // it began anew where the last step ended
    bool stale = false;  // it had no answer where the last step ended
  };
  Kept kept_;
  Accepted accepted_;
  Trial trial_;
  Lost lost_;
  Matrix6 stiffness_ = Matrix6::Zero();  // where a touch began or a prediction was poor last
  double foresees_;                      // longest step that the pad lets a scene make [s]
  Eigen::MatrixXd J_;
};

}  // namespace thenar
