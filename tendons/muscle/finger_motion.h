#pragma once

/// Equations of motion of one digit driven by its muscles.

#include "hand/multibody.h"
#include "tendons/digit_tendons.h"
#include "tendons/muscle/contraction.h"
#include "tendons/muscle/joint_resistance.h"
#include "tendons/muscle/musculotendon.h"
#include "tendons/muscle/trajectory.h"

namespace thenar {

/// Tension added to that of every muscle of a digit with a net in motion, so that no band goes
/// fully slack [N]. It is numerical and does not model muscle tone. Our choice: see
/// docs/theory/muscles.md.
inline constexpr double kBaseTension = 20e-3;

/// Stretch at F0, over the optimal fibre length, of the compliant tendon that replaces a rigid one
/// under a net [1]. Our choice: see docs/theory/muscles.md.
inline constexpr double kRigidStrain = 0.01;

/// Rate at which excursions follow the line lengths of a net [1/s]: a time constant of 0.01 ms, a
/// tenth of the time that a fibre takes to follow. Our choice.
inline constexpr double kFollowRate = 1e5;

/// Constants of a digit in motion. Refers to the tendons and the contraction, which must outlive
/// it; temporaries are rejected.
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
  double blend = kBlendStrain;         // smoothing strain of a net's bands [1]
  double base_tension = kBaseTension;  // tension added to each muscle of a digit with a net [N]
};

/// States of a digit in motion.
struct MotionState {
  Eigen::VectorXd q;           // posture [rad] (coordinates)
  Eigen::VectorXd q_dot;       // [rad/s] (coordinates)
  Eigen::VectorXd activation;  // [1] (muscles)
  Eigen::VectorXd excursion;   // lengthening since the reference posture [m] (muscles; empty where
                               // it is not a state)
  Eigen::VectorXd projected_fibre;  // length of the fibres along their tendons [m] (muscles; empty
                                    // where it is not a state)
  double work = 0;                  // work of the tendons on the joints [J]
  double dissipated = 0;            // energy lost in the dampers of the joints [J]
};

/// Initial state of a motion.
struct [[nodiscard]] MotionOnset {
  MotionState state;
  std::string warning;  // reason why the excursion may be wrong; may be empty
};

/// Quantities derived from a state.
struct MotionInstant {
  Eigen::VectorXd tension;    // [N] (muscles)
  Eigen::VectorXd excursion;  // lengthening since the reference posture [m] (muscles)
  Eigen::VectorXd fibre;      // length over optimal fibre length [1] (muscles)
  TendonTorque pull;
};

/// Equations of motion of a digit. The states change by
///   M q'' = tau_tendons + tau_springs_and_stops - damping q' + weights and inertia,
///   a' by activation_rate,  excursion' by excursion_rate(),  projected_fibre' by the contraction,
///   work' = tau_tendons . q',  dissipated' = q' . damping q'.
/// A muscle and its tendon have the length  musculotendon_length_at_optimum() + excursion:  every
/// fibre is at its optimal length in the subject's reference posture, our choice where subjects
/// state nothing better.
///
/// The bones are a Simbody system. Nets are massless and always in equilibrium, followed from the
/// last accepted state by TendonFollower. With rigid tendons, tension depends on velocity and,
/// through a net's moment arms, velocity on tension. Under a net a rigid tendon is therefore
/// replaced by one that stretches by kRigidStrain: the projected fibre becomes a state, and tension
/// follows from states alone. Where every muscle pulls the net by one band at most, net and tendons
/// minimise one common energy, and excursions follow from that equilibrium instead of being states.
class FingerMotion {
 public:
  /// Builds the equations. @throws InputError if the contraction has other muscles than the digit.
  explicit FingerMotion(const MotionModel& model);

  /// Computes the initial state at a posture: the excursion from the reference posture, and fibres
  /// in equilibrium.
  /// @param activation  0..1 [1] (muscles)
  /// @throws InputError if a length is wrong or an entry not finite.
  MotionOnset start(const Eigen::VectorXd& q, const Eigen::VectorXd& q_dot,
                    const Eigen::VectorXd& activation);

  /// Computes the rates of all states.
  /// @param excitation  0..1 [1] (muscles)
  /// @return rates, in the layout of the states
  [[nodiscard]] MotionState slope(const MotionState& state, const Eigen::VectorXd& excitation);

  /// Computes the Jacobian of all rates by all states, packed alike:  J_ij = d slope_i / d y_j.
  ///
  /// The stiff terms are exact: muscles, resistance of joints, torque of tendons by posture and
  /// tension. Derivatives of moment arms and of the multibody's terms are finite differences of
  /// smooth functions.
  [[nodiscard]] Eigen::MatrixXd jacobian(const MotionState& state,
                                         const Eigen::VectorXd& excitation);

  /// Computes the quantities derived from a state.
  [[nodiscard]] MotionInstant instant_at(const MotionState& state) const;

  /// Tendons in an accepted state.
  struct Accepted {
    std::string warning;    // reason why they may be wrong; may be empty
    Eigen::VectorXd drift;  // difference between excursions and line lengths, of muscles that pull;
                            // 0 for slack ones [m] (muscles); empty without a net
    NetStep net;            // snaps and energy error since the state accepted before
  };

  /// Returns whether a net snaps between the last accepted state and this one.
  [[nodiscard]] bool snaps_before(const MotionState& state) const;

  /// Accepts a state, from which the net is then followed.
  Accepted accept(const MotionState& state);

  /// Returns the number of evaluations of the net's energy so far, a measure of the work done.
  [[nodiscard]] long effort() const { return effort_; }

  /// Returns the reason why the last rates are not finite; may be empty.
  [[nodiscard]] const std::string& obstacle() const { return obstacle_; }

  /// Computes the energy of motion, weights, springs and stops [J].
  [[nodiscard]] double energy(const MotionState& state);

  /// Computes the kinetic energy [J].
  [[nodiscard]] double kinetic_energy(const MotionState& state);

  /// Packs all states into one vector, and back.
  [[nodiscard]] Eigen::VectorXd pack(const MotionState& state) const;
  [[nodiscard]] MotionState unpack(const Eigen::VectorXd& y) const;

  /// Returns the scale of each state for a relative tolerance: 1 rad, 1 rad/s, 1, 1 cm, 1 cm, 1 mJ,
  /// 1 mJ. Packed.
  [[nodiscard]] Eigen::VectorXd scale() const;

 private:
  /// Computes the tendon torque, from the follower if there is a net.
  [[nodiscard]] TendonTorque tendon_torque(const Eigen::VectorXd& q,
                                           const Eigen::VectorXd& t) const;
  /// Gathers the state of muscle m. @param excursion  lengthening since the reference posture [m]
  /// (muscles)
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

  /// Computes the far ends of the tendons: a tendon's length is its line's length less its end [m]
  /// (muscles).
  [[nodiscard]] Eigen::VectorXd tendon_ends(const Eigen::VectorXd& projected_fibre) const;

  /// Returns the loads of the net's follower: tensions, or far ends of tendons.
  [[nodiscard]] Eigen::VectorXd load(const MotionState& state, const MotionInstant& now) const {
    return on_tendons_ ? tendon_ends(state.projected_fibre) : now.tension;
  }

  /// Switches to elastic tendons from an equilibrium state, if the net allows it; excursions are
  /// then no longer states.
  void switch_to_tendons(MotionState& state, const MotionInstant& now);

  /// Computes fibre lengths over optimal fibre lengths [1] (muscles).
  [[nodiscard]] Eigen::VectorXd fibres(const MotionState& state,
                                       const Eigen::VectorXd& excursion) const;

  /// Returns quantities for a trial state far from any solution: their torques make the integrator
  /// shorten its step.
  [[nodiscard]] MotionInstant rejected_instant(MotionInstant now) const;

  [[nodiscard]] Eigen::MatrixXd state_jacobian(const MotionState& state, const MotionInstant& now,
                                               Eigen::MatrixXd& J) const;
  [[nodiscard]] Eigen::MatrixXd jacobian_on_tendons(const MotionState& state,
                                                    const MotionInstant& now,
                                                    Eigen::MatrixXd& J) const;

  /// Computes the change of line lengths since the reference posture, with the net in equilibrium
  /// [m] (muscles).
  [[nodiscard]] Eigen::VectorXd line_excursion(const MotionState& state,
                                               const MotionInstant& now) const;

  /// Computes the rates of excursions:  -R q',  and under a net  kFollowRate (x - excursion)  in
  /// addition, with x the line lengths in its equilibrium. Since x falls with tension, and tension
  /// rises with excursion, excursions converge to the unique balance of both [m/s] (muscles).
  [[nodiscard]] Eigen::VectorXd excursion_rate(const MotionState& state,
                                               const MotionInstant& now) const;

  MotionModel model_;
  std::unique_ptr<DigitTendons> blended_;   // smoothed tendons; null: the model's own
  std::unique_ptr<Contraction> compliant_;  // muscles on compliant tendons; null: the model's own
  Multibody multibody_;
  Eigen::VectorXd damping_;  // [N m s/rad] (coordinates)
  double base_tension_;      // [N]
  Eigen::Index muscles_;
  std::unique_ptr<TendonFollower> follower_;  // follower of the net; null: no net
  bool on_tendons_ = false;                   // true: net and elastic tendons minimise one energy
  long effort_ = 0;
  std::string obstacle_;
  /// Line lengths at which excursions are 0 [m] (muscles; empty: no net).
  Eigen::VectorXd slack_length_;
};

}  // namespace thenar
