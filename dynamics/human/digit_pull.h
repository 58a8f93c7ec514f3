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

/// The constants of a pulled digit.
struct DigitPullModel {
  std::string name;                            // "human/index"
  std::shared_ptr<const TendonGroup> tendons;  // one digit, or several that share a muscle
  CoordinatePlaces places;                     // of the group's coordinates
  std::vector<MuscleSchedule> tensions;        // of muscles that do not contract
  std::vector<MuscleSchedule> excitations;     // others are not excited
  std::shared_ptr<const Contraction>
      contraction;  // of all muscles; what it says of those
                    // with a tension is not used; null: none contracts
  ActivationTimes activation{};
  double blend = kBlendStrain;         // of a net's bands [1]
  double base_tension = kBaseTension;  // added to each muscle of a digit with a net [N]
};

/// State of tendons and muscles at an instant.
struct PullInstant {
  Eigen::VectorXd tension;     // [N] (muscles)
  Eigen::VectorXd excitation;  // [1] (muscles); 0 of muscles that do not contract
  Eigen::VectorXd activation;  // [1] (muscles); likewise
  Eigen::VectorXd excursion;   // lengthening since the reference posture [m] (muscles); 0 where
                               // tension does not depend on it
  TendonStatus status = TendonStatus::kValid;
  std::string warning;  // why not to trust it; may be empty
};

/// Tensions of a pull's muscles at once; a copy has room of its own.
class PullTensions {
 public:
  /// @param of  must outlive it
  explicit PullTensions(const Contraction& of) : of_(&of), solver_(of.tension_solver()) {}
  PullTensions(const PullTensions& other) : PullTensions(*other.of_) {}
  PullTensions& operator=(const PullTensions&) = delete;
  ~PullTensions() = default;

  TensionSolver& solver() { return *solver_; }

 private:
  const Contraction* of_;
  std::unique_ptr<TensionSolver> solver_;
};

/// A digit's tendons as a force element: the physics of FingerMotion, without its bones.
///
/// Torque is that of DigitTendons at the tensions. States are, of each muscle that contracts, its
/// activation, and where tension depends on them its excursion and the projected length of its
/// fibres, both over the optimal length of its fibres:
///   a' by activation_rate,  excursion' = -R q' - G t',  projected_fibre' by the contraction.
/// Muscles begin at rest, activation 0, with fibres in balance. Under a net, tensions depend on
/// states alone, and excursions are drawn back to the lengths of lines, as in FingerMotion.
///
/// Slopes for steps are  K = -d tau/d q at constant tension + R' (dt/d excursion) A^-1 R  and
/// R' (dt/d velocity) R,  A = 1 + G dt/d excursion. The first term of K, the dearest and smallest,
/// takes the slopes of arms of the last accept() at which the posture had changed much, and the
/// tensions of now; where arms have no slopes, as under a net, it is that of the last accept() at
/// which posture or tensions had changed much.
class DigitPull final : public ForceElement {
 public:
  /// @throws InputError if shapes or names of muscles disagree, a muscle has a tension and
  /// contracts, a schedule is empty or falls in time, or two of one muscle act at once.
  explicit DigitPull(DigitPullModel model);

  [[nodiscard]] std::unique_ptr<ForceElement> clone() const override;
  [[nodiscard]] std::string name() const override { return model_->name; }
  [[nodiscard]] std::vector<std::string> state_names() const override;
  [[nodiscard]] Eigen::VectorXd start(const Eigen::VectorXd& q) const override;
  /// Returns the reason not to trust the excursions that start() finds; may be empty.
  [[nodiscard]] std::string start_warning(const Eigen::VectorXd& q) const;
  bool act(const ElementInput& at, ElementAction& out) override;
  void accept(const ElementInput& at) override;
  [[nodiscard]] std::vector<double> switches() const override;
  [[nodiscard]] bool moves(const ElementInput& at) const override;
  /// The excitation of each muscle that contracts, the tension of each other one, called after the
  /// muscle: "human/index/FDP2". What is set holds in place of schedules.
  [[nodiscard]] std::vector<ElementControl> controls() const override;
  bool set_control(const std::string& name, double value) override;
  /// Tension of each muscle [N], and "human/index/FDP2 activation" of each that contracts [1].
  [[nodiscard]] std::vector<ElementValue> readings(const ElementInput& at) override;

  /// Returns the model from which the pull was built.
  [[nodiscard]] const DigitPullModel& model() const { return *model_; }
  /// Names of the muscles.
  [[nodiscard]] const std::vector<std::string>& muscles() const;
  /// Returns true if a muscle contracts.
  [[nodiscard]] bool contracts(int muscle) const;
  /// Computes the state of tendons and muscles at an instant, after accept() of that instant.
  [[nodiscard]] PullInstant at(const ElementInput& at) const;

 private:
  /// Quantities that follow from the states.
  struct Now {
    Eigen::VectorXd q, q_dot;    // of the group (coordinates)
    Eigen::VectorXd excitation;  // 0 of muscles that do not contract (muscles)
    MuscleStates state;          // likewise (muscles)
    Eigen::VectorXd excursion;   // likewise (muscles)
    MuscleTensions by;           // by contraction (muscles)
    Eigen::VectorXd tension;     // (muscles)
    Eigen::VectorXd stretch;     // lengthening of muscles [m/s] (muscles)
    GroupTorque pull;            // without a net its arms stay while the posture does
  };
  [[nodiscard]] ElementNeed need_of(const ElementInput& at) const;
  /// Fills now_: tensions and torque but for kStates, their derivatives for kAll.
  [[nodiscard]] const Now& now(const ElementInput& at, ElementNeed need) const;
  void set_arms(const Eigen::VectorXd& q) const;
  [[nodiscard]] bool is_finite(const ElementInput& at) const;
  void set_states(const ElementInput& at, Now& now) const;
  void set_tensions(double t, ElementNeed need, Now& now) const;
  void add_tension_slopes(const Now& now, ElementAction& out);
  void add_slopes(const Now& now, Eigen::MatrixXd& G, Eigen::MatrixXd& A, ElementAction& out);
  [[nodiscard]] bool knows_stiffness(const Eigen::VectorXd& q, const Eigen::VectorXd& t) const;
  bool set_arm_slopes(const Eigen::VectorXd& q);
  void set_posture_stiffness(const Now& now);
  [[nodiscard]] bool has_net() const { return blended_ != nullptr; }
  [[nodiscard]] const TendonGroup& tendons() const {
    return blended_ ? *blended_ : *model_->tendons;
  }
  [[nodiscard]] const Contraction& contraction() const {
    return compliant_ ? *compliant_ : *model_->contraction;
  }
  void set_rates(const ElementInput& at, const Now& now, ElementAction& out) const;
  void set_excursion_rates(const ElementInput& at, const Now& now, const Eigen::MatrixXd& G,
                           const Eigen::MatrixXd& A, ElementAction& out);

  /// Which muscles contract, which states they have, and the lengths by which these are scaled.
  struct Muscles {
    std::vector<int> contracting;  // muscles
    std::vector<bool> contracts;   // (muscles)
    bool has_excursion = false, has_fibre = false, feels_speed = false;
    Eigen::Index count = 0, states = 0;
    Eigen::VectorXd fibre_length, length_at_optimum;  // of the contraction [m] (muscles)
  };
  /// What earlier calls found and later ones begin with.
  struct Last {
    GroupSlopes arm_slopes;                    // at the last accept(), where they exist; else
    Eigen::MatrixXd posture_stiffness;         // (coordinates, coordinates)
    Eigen::VectorXd tension;                   // of the last act() [N] (muscles)
    Eigen::VectorXd stiffness_q, stiffness_t;  // where either was found; empty: not yet
    GroupNodes nodes;                          // of nets at the last accept() [m]
    Eigen::VectorXd slack_length;  // of lines where excursions are 0 [m] (muscles; empty: not held)
  };
  /// Vectors whose memory is used again; they change no answer.
  struct Scratch {
    Eigen::VectorXd excursion_rate, accepted_q, by_arm, by_pair;
  };

  std::shared_ptr<const DigitPullModel> model_;
  std::shared_ptr<const TendonGroup> blended_;    // null: the model's own
  std::shared_ptr<const Contraction> compliant_;  // null: the model's own
  Muscles muscles_;
  Last last_;
  // Of the last look at a state; used again, they change no answer.
  mutable Now now_;
  mutable std::optional<GroupArms> arms_;         // none: a net
  mutable Eigen::VectorXd arms_q_;                // where the arms of now_ are, without a net
  mutable std::optional<PullTensions> tensions_;  // none: none contracts
  // Tensions [N] and excitations [1]: those set by hand, and the pieces of the last look.
  mutable ActingPieces given_, excited_;
  Scratch scratch_;
};

}  // namespace thenar
