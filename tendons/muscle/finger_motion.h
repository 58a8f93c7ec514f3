#pragma once

/// The equations of motion of one digit under its muscles.

#include "hand/multibody.h"
#include "tendons/digit_tendons.h"
#include "tendons/muscle/contraction.h"
#include "tendons/muscle/joint_resistance.h"
#include "tendons/muscle/musculotendon.h"
#include "tendons/muscle/trajectory.h"

namespace thenar {

/// Tension that is added to that of every muscle of a digit with a net in motion, so that no band
/// goes fully slack: numerical, not the tone of a muscle; a choice of ours [N]: see
/// docs/theory/muscles.md.
inline constexpr double kBaseTension = 20e-3;

/// Stretch at F0 of the tendon that stands for a rigid one under a net, over the optimal length of
/// the fibre, a choice of ours [1]: see docs/theory/muscles.md.
inline constexpr double kRigidStrain = 0.01;

/// Rate at which excursions follow the lines of a net, a choice of ours [1/s]: within 0.01 ms, a
/// tenth of what a fibre takes to follow.
inline constexpr double kFollowRate = 1e5;

/// The constants of a digit in motion. Refers to the tendons and the contraction, which must
/// outlive it; temporaries are refused.
struct MotionModel {
  MotionModel(const DigitTendons& of_tendons, const Contraction& of_contraction)
      : tendons(of_tendons), contraction(of_contraction) {}
  MotionModel(const DigitTendons&&, const Contraction&) = delete;
  MotionModel(const DigitTendons&, const Contraction&&) = delete;
  MotionModel(const DigitTendons&&, const Contraction&&) = delete;

  const DigitTendons& tendons;
  const Contraction& contraction;
  JointResistance resistance{};
  ActivationTimes activation{};
  Eigen::Vector3d gravity{0, 0, 0};    // acceleration of free fall, base frame [m/s^2] (3)
  double blend = kBlend;               // of a net's bands [1]
  double base_tension = kBaseTension;  // added to each muscle of a digit with a net [N]
};

/// All states of a digit in motion.
struct MotionState {
  Eigen::VectorXd q;                // posture [rad] (coordinates)
  Eigen::VectorXd q_dot;            // [rad/s] (coordinates)
  Eigen::VectorXd activation;       // [1] (muscles)
  Eigen::VectorXd excursion;        // lengthening since the reference posture [m] (muscles; empty
                                    // where it is no state)
  Eigen::VectorXd projected_fibre;  // of the fibres [m] (muscles; empty where it is no state)
  double work = 0;                  // of the tendons on the joints [J]
  double dissipated = 0;            // in the dampers of the joints [J]
};

/// The first state of a motion.
struct [[nodiscard]] MotionOnset {
  MotionState state;
  std::string warning;  // why its excursion may be wrong; may be empty
};

/// Quantities that follow from a state.
struct MotionInstant {
  Eigen::VectorXd tension;    // [N] (muscles)
  Eigen::VectorXd excursion;  // lengthening since the reference posture [m] (muscles)
  Eigen::VectorXd fibre;      // length over optimal fibre length [1] (muscles)
  TendonTorque pull;
};

/// States change by
///   M q'' = tau_tendons + tau_springs_and_stops - damping q' + weights and inertia,
///   a' by activation_rate,  excursion' by excursion_rate(),  projected_fibre' by the contraction,
///   work' = tau_tendons . q',  dissipated' = q' . damping q'.
/// A muscle and its tendon are musculotendon_length_at_optimum() + excursion long: by a choice of
/// ours every fibre is at its optimal length at the subject's reference posture, as no subject says
/// better.
///
/// Bones move by Simbody; nets are massless and at rest at every instant, where they come to from
/// the last accepted state: TendonFollower. On rigid tendons tension depends on velocity, and
/// velocity, by a net's moment arms, on tension; under a net a rigid tendon is therefore replaced
/// by one that stretches by kRigidStrain, so that the projected fibre is a state and tension
/// follows from states alone. Net and tendons then rest in the least of one energy, and excursions
/// follow from where they do: as no state, where every muscle pulls the net by one band at most.
class FingerMotion {
 public:
  /// @throws InputError if the contraction has other muscles than the digit.
  explicit FingerMotion(const MotionModel& model);

  /// Starts a motion at a posture, with the excursion from the reference posture, and fibres in
  /// balance.
  /// @param activation  (muscles)
  /// @throws InputError if a length is wrong or an entry not finite.
  MotionOnset start(const Eigen::VectorXd& q, const Eigen::VectorXd& q_dot,
                    const Eigen::VectorXd& activation);

  /// @param excitation  0..1 [1] (muscles)
  /// @return rates of all states
  [[nodiscard]] MotionState slope(const MotionState& state, const Eigen::VectorXd& excitation);

  /// Derivatives of all rates by all states, packed alike:  J_ij = d slope_i / d y_j.
  ///
  /// The stiff terms are exact: muscles, resistance of joints, torque of tendons by posture and
  /// tension. Derivatives of moment arms and of the multibody's terms are differences of smooth
  /// functions.
  [[nodiscard]] Eigen::MatrixXd jacobian(const MotionState& state,
                                         const Eigen::VectorXd& excitation);

  [[nodiscard]] MotionInstant at(const MotionState& state) const;

  /// Tendons in an accepted state.
  struct Accepted {
    std::string warning;    // why they may be wrong; may be empty
    Eigen::VectorXd drift;  // of excursions from the lines of muscles that pull; 0 of slack ones
                            // [m] (muscles); empty without a net
    NetStep net;            // since the state accepted before
  };

  /// Returns whether a net snaps between the state accepted last and this one.
  [[nodiscard]] bool snaps_before(const MotionState& state) const;

  /// Accepts a state: from here the net is followed on.
  Accepted accept(const MotionState& state);

  /// Evaluations of a net's energy so far: the work that a motion takes, counted.
  [[nodiscard]] long effort() const { return effort_; }

  /// Returns the reason why the last rates are not finite; may be empty.
  [[nodiscard]] const std::string& obstacle() const { return obstacle_; }

  /// Energy of motion, weights, springs and stops [J].
  [[nodiscard]] double energy(const MotionState& state);

  /// Energy of motion alone [J].
  [[nodiscard]] double kinetic_energy(const MotionState& state);

  /// All states in one column, and back.
  [[nodiscard]] Eigen::VectorXd pack(const MotionState& state) const;
  [[nodiscard]] MotionState unpack(const Eigen::VectorXd& y) const;

  /// Size below which no state is resolved at a relative tolerance of 1: 1 rad, 1 rad/s, 1, 1 cm,
  /// 1 cm, 1 mJ, 1 mJ. Packed.
  [[nodiscard]] Eigen::VectorXd scale() const;

 private:
  [[nodiscard]] TendonTorque pull_at(const Eigen::VectorXd& q, const Eigen::VectorXd& t) const;
  /// @param excursion  (muscles)
  [[nodiscard]] MuscleState muscle_state(const MotionState& state, const Eigen::VectorXd& excursion,
                                         int m) const;
  [[nodiscard]] const DigitTendons& tendons() const {
    return blended_ ? *blended_ : model_.tendons;
  }
  [[nodiscard]] const Contraction& contraction() const {
    return compliant_ ? *compliant_ : model_.contraction;
  }
  [[nodiscard]] Eigen::VectorXd tension(const MotionState& state,
                                        const Eigen::VectorXd& velocity) const;

  /// Ends of tendons, so long as their lines less these [m] (muscles).
  [[nodiscard]] Eigen::VectorXd tendon_ends(const Eigen::VectorXd& projected_fibre) const;

  /// Loads that the net is asked to follow: tensions, or ends of tendons.
  [[nodiscard]] Eigen::VectorXd load(const MotionState& state, const MotionInstant& now) const {
    return on_tendons_ ? tendon_ends(state.projected_fibre) : now.tension;
  }

  /// Hangs muscles on tendons from a state at rest, where the net can; then excursions are no
  /// state.
  void rest_on_tendons(MotionState& state, const MotionInstant& now);

  /// Fibre lengths over optimal fibre lengths [1] (muscles).
  [[nodiscard]] Eigen::VectorXd fibres(const MotionState& state,
                                       const Eigen::VectorXd& excursion) const;

  /// Returns the rates of a trial far from any solution: torques that make the integrator take a
  /// shorter step.
  [[nodiscard]] MotionInstant far_off(MotionInstant now) const;

  [[nodiscard]] Eigen::MatrixXd slopes_of_states(const MotionState& state, const MotionInstant& now,
                                                 Eigen::MatrixXd& J) const;
  [[nodiscard]] Eigen::MatrixXd slopes_on_tendons(const MotionState& state,
                                                  const MotionInstant& now,
                                                  Eigen::MatrixXd& J) const;

  /// Lengths of lines since the reference posture, as they are where the net rests [m] (muscles).
  [[nodiscard]] Eigen::VectorXd line_excursion(const MotionState& state,
                                               const MotionInstant& now) const;

  /// Rates of excursions:  -R q',  and under a net  kFollowRate (x - excursion)  beside it, x the
  /// lengths of lines where it rests. As these fall with tension, and tension rises with excursion,
  /// excursions come to the one balance of both [m/s] (muscles).
  [[nodiscard]] Eigen::VectorXd excursion_rate(const MotionState& state,
                                               const MotionInstant& now) const;

  MotionModel model_;
  std::unique_ptr<DigitTendons> blended_;   // null: the model's own
  std::unique_ptr<Contraction> compliant_;  // null: the model's own
  Multibody multibody_;
  Eigen::VectorXd damping_;  // [N m s/rad] (coordinates)
  double base_tension_;      // [N]
  Eigen::Index muscles_;
  std::unique_ptr<TendonFollower> follower_;  // null: no net
  bool on_tendons_ = false;                   // it has net and tendons in one energy
  long effort_ = 0;
  std::string obstacle_;
  Eigen::VectorXd slack_length_;  // of lines where excursions are 0 [m] (muscles; empty: no net)
};

}  // namespace thenar
