#pragma once

/// Tendons of a digit in a scene, pulled by given tensions or by excited muscles.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/human/joint_stops.h"
#include "dynamics/human/muscle_schedule.h"
#include "dynamics/human/tendon_group.h"
#include "dynamics/stepping/moving_scene.h"
#include "tendons/muscle/contraction.h"
#include "tendons/muscle/finger_motion.h"

namespace thenar {

/// Constants of the tendons and muscles of a pulled digit.
struct DigitPullModel {
  std::string name;                            // name of the element, "human/index"
  std::shared_ptr<const TendonGroup> tendons;  // one digit, or several that share a muscle
  CoordinateIndices indices;                   // indices of the group's coordinates in the scene
  std::vector<MuscleSchedule> tensions;        // tensions of muscles that do not contract
  std::vector<MuscleSchedule> excitations;     // excitations of muscles that contract; default 0
  std::shared_ptr<const Contraction> contraction;  // all muscles; not used for those with a
                                                   // tension; null: no muscle contracts
  ActivationTimes activation{};                    // time constants of activation
  double blend = kBlendStrain;         // strain over which bands of a net become taut [1]
  double base_tension = kBaseTension;  // tension added to each muscle of a digit with a net [N]
};

/// Layout of the states of a pulled digit, and the lengths that scale them.
struct MuscleLayout {
  std::vector<int> contracting;        // indices of contracting muscles
  std::vector<bool> contracts;         // flag of each muscle (muscles)
  bool has_excursion = false;          // flag: excursion is a state
  bool has_fibre = false;              // flag: projected fibre length is a state
  bool depends_on_velocity = false;    // flag: tension depends on the lengthening rate
  Eigen::Index total = 0, states = 0;  // number of muscles, and of states of this element
  Eigen::VectorXd fibre_length;        // optimal fibre length [m] (muscles)
  Eigen::VectorXd length_at_optimum;   // musculotendon length at that fibre length [m] (muscles)
};

/// State of tendons and muscles at an instant.
struct PullState {
  Eigen::VectorXd tension;     // tension [N] (muscles)
  Eigen::VectorXd excitation;  // excitation [1] (muscles); 0 for muscles that do not contract
  Eigen::VectorXd activation;  // activation [1] (muscles); 0 for muscles that do not contract
  Eigen::VectorXd excursion;   // lengthening since the reference posture [m] (muscles); 0 where
                               // tension does not depend on it
  TendonStatus status = TendonStatus::kValid;  // reliability of the torque
  std::string warning;                         // reason not to trust it; may be empty
};

/// TensionSolver of a contraction that can be copied; each copy has its own workspace.
class CopyableTensionSolver {
 public:
  /// @param of  contraction, which must outlive the solver
  explicit CopyableTensionSolver(const Contraction& of) : of_(&of), solver_(of.tension_solver()) {}
  CopyableTensionSolver(const CopyableTensionSolver& other) : CopyableTensionSolver(*other.of_) {}
  CopyableTensionSolver& operator=(const CopyableTensionSolver&) = delete;
  ~CopyableTensionSolver() = default;

  TensionSolver& solver() { return *solver_; }

 private:
  const Contraction* of_;
  std::unique_ptr<TensionSolver> solver_;
};

/// Tendons and muscles of a digit as a force element, with the same equations as FingerMotion.
///
/// The torque is that of DigitTendons at the muscle tensions. The states of a contracting muscle
/// are its activation and, where tension depends on them, its excursion and the projected length of
/// its fibres, both over the optimal fibre length:
///   a' = activation_rate(),  excursion' = -R q' - G t',  projected_fibre' by the contraction.
/// Muscles start with activation 0 and fibres in equilibrium. For a tendon net, tensions depend on
/// states alone, and excursions are stabilized towards the tendon lengths, as in FingerMotion.
///
/// The stiffness is  K = -d tau/d q at constant tension + R' (dt/d excursion) A^-1 R, the damping
/// R' (dt/d velocity) R,  with A = 1 + G dt/d excursion. The first term of K is the smallest and
/// the most expensive. Without a net it is evaluated at the present tensions from slopes of the
/// moment arms, which accept_step() updates when the posture has changed by kStiffnessUpdateAngle.
/// Where arms have no slopes, as with a net, accept_step() updates the term itself when posture or
/// tensions have changed much.
///
/// Const functions share a workspace, so they are not thread-safe: use one clone() per thread.
class DigitPull final : public ForceElement {
 public:
  /// @throws InputError if shapes or names of muscles disagree, a muscle with a tension is also
  /// excited, a schedule is empty or its times decrease, or two schedules of a muscle overlap.
  explicit DigitPull(DigitPullModel model);

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override {
    return std::make_unique<DigitPull>(*this);
  }
  [[nodiscard]] std::string name() const override { return model_->name; }
  [[nodiscard]] std::vector<std::string> state_names() const override;
  [[nodiscard]] Eigen::VectorXd initial_states(const Eigen::VectorXd& q) const override;
  /// Returns the reason not to trust the excursions of initial_states(); may be empty.
  [[nodiscard]] std::string start_warning(const Eigen::VectorXd& q) const;
  bool add_action(const ElementInput& at, ElementAction& out) override;
  void accept_step(const ElementInput& at) override;
  [[nodiscard]] std::vector<double> switching_times() const override;
  [[nodiscard]] bool may_start_motion(const ElementInput& at) const override;
  /// Returns the excitation of each contracting muscle and the tension of each other muscle, named
  /// after the muscle: "human/index/FDP2". A value that is set overrides the schedules.
  [[nodiscard]] std::vector<ElementControl> controls() const override;
  bool set_control(const std::string& name, double value) override;
  /// Returns the tension of each muscle [N], and the activation of each contracting muscle, named
  /// "human/index/FDP2 activation" [1].
  [[nodiscard]] std::vector<ElementValue> readings(const ElementInput& at) override;

  /// Returns the model from which the pull was built.
  [[nodiscard]] const DigitPullModel& model() const { return *model_; }
  /// Returns the names of the muscles.
  [[nodiscard]] const std::vector<std::string>& muscles() const {
    return model_->tendons->muscles();
  }
  /// Returns true if a muscle contracts.
  [[nodiscard]] bool contracts(int muscle) const { return muscles_.contracts[muscle]; }
  /// Computes the state of tendons and muscles at an instant. Requires accept_step() at that
  /// instant.
  [[nodiscard]] PullState state_at(const ElementInput& at) const;

 private:
  /// Quantities of all muscles at one state; zero for muscles without such a state.
  struct PullValues {
    Eigen::VectorXd q, q_dot;    // posture and speed of the group [rad], [rad/s] (coordinates)
    Eigen::VectorXd excitation;  // excitation [1] (muscles)
    MuscleStates state;          // states of contracting muscles (muscles)
    Eigen::VectorXd excursion;   // excursion of contracting muscles [m] (muscles)
    MuscleTensions contracted;   // tensions by contraction, with derivatives (muscles)
    Eigen::VectorXd tension;     // tension, contracted or given [N] (muscles)
    Eigen::VectorXd lengthening_rate;  // -R q' [m/s] (muscles)
    GroupTorque torque;                // torque; without a net R is reused at the same posture
  };
  [[nodiscard]] ElementNeed effective_need(const ElementInput& at) const;
  /// Computes values_: tensions and torque unless only states are needed, their derivatives for
  /// kAll.
  [[nodiscard]] const PullValues& evaluate(const ElementInput& at, ElementNeed need) const;
  void set_arms(const Eigen::VectorXd& q) const;
  [[nodiscard]] bool has_finite_inputs(const ElementInput& at) const;
  void set_states(const ElementInput& at, PullValues& values) const;
  void set_tensions(double t, ElementNeed need, PullValues& values) const;
  void add_tension_slopes(const PullValues& values, ElementAction& out);
  void add_slopes(const PullValues& values, Eigen::MatrixXd& G, Eigen::MatrixXd& A,
                  ElementAction& out);
  [[nodiscard]] bool has_stiffness_near(const Eigen::VectorXd& q, const Eigen::VectorXd& t) const;
  bool set_arm_slopes(const Eigen::VectorXd& q);
  void set_posture_stiffness(const PullValues& values);
  [[nodiscard]] bool has_net() const { return blended_ != nullptr; }
  [[nodiscard]] const TendonGroup& tendons() const {
    return blended_ ? *blended_ : *model_->tendons;
  }
  [[nodiscard]] const Contraction& contraction() const {
    return compliant_ ? *compliant_ : *model_->contraction;
  }
  void set_rates(const ElementInput& at, const PullValues& values, ElementAction& out) const;
  void set_excursion_rates(const ElementInput& at, const PullValues& values,
                           const Eigen::MatrixXd& G, const Eigen::MatrixXd& A, ElementAction& out);

  /// Results of earlier calls that later calls start from.
  struct Cache {
    GroupSlopes arm_slopes;             // slopes of arms at stiffness_q, where they exist
    Eigen::MatrixXd posture_stiffness;  // -d tau/d q at stiffness_q and stiffness_t, otherwise
                                        // [N m/rad] (coordinates, coordinates)
    Eigen::VectorXd tension;            // tension in the last add_action() [N] (muscles)
    Eigen::VectorXd stiffness_q, stiffness_t;  // posture [rad] and tension [N]; empty: not set yet
    GroupNodes nodes;                          // nodes of nets at the last accept_step() [m]
    Eigen::VectorXd slack_length;  // line lengths at excursion 0 [m] (muscles); empty: excursions
                                   // are not stabilized
  };
  /// Workspace that is reused between calls and does not affect results.
  struct Scratch {
    Eigen::VectorXd excursion_rate, accepted_q, weighted_arms, pair_sums;
  };

  std::shared_ptr<const DigitPullModel> model_;
  std::shared_ptr<const TendonGroup> blended_;    // tendons with a smoothed net; null: the model's
  std::shared_ptr<const Contraction> compliant_;  // contraction on compliant tendons of a net;
                                                  // null: the model's
  MuscleLayout muscles_;
  Cache cache_;
  // Workspace of evaluate(), which does not affect results.
  mutable PullValues values_;
  mutable std::optional<GroupArms> arms_;                // solver of moment arms; none: a net
  mutable Eigen::VectorXd arms_q_;                       // posture of the arms in values_
  mutable std::optional<CopyableTensionSolver> solver_;  // none: no muscle contracts
  // Tensions [N] and excitations [1]: values set by controls, and the pieces last selected.
  mutable ActiveSchedulePieces tension_pieces_, excitation_pieces_;
  Scratch scratch_;
};

}  // namespace thenar
