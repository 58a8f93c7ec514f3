#pragma once

/// Joint torque from tendon tensions on one digit, at any level of path and hood detail.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/error.h"
#include "tendons/tendon_model.h"
#include "tendons/tension_law.h"

namespace thenar {

struct NetEquilibrium;

/// Reliability of the tendon torque, from good to bad.
enum class TendonStatus {
  kValid,        // paths are taut, a net is in equilibrium at an energy minimum
  kApproximate,  // fitted arms may be off by more than 1 mm/rad, or an origin lies on a bend of its
                 // carrier
  kBandInsideBone,  // a band in tension ends inside the bone over which it bends
  kNodeCollapsed,   // a muscle has pulled a node into its exit: the net does not hold the pull, or
                    // only part of it
  kOutOfRange,   // a fitted path is evaluated outside its joints' ranges, where polynomials diverge
  kInvalidPath,  // a wrapped path is not taut, has a point in bone or went round the far side
  kUnstable,     // a net in equilibrium at a saddle: any disturbance moves it elsewhere
  kOverstrained,  // a net balanced by bands loaded beyond what tissue can carry
  kUnbalanced     // a net without equilibrium: its torque is meaningless
};

/// Returns whether results with this status may be used: those up to kBandInsideBone.
[[nodiscard]] constexpr bool is_trusted(TendonStatus status) {
  return status < TendonStatus::kNodeCollapsed;
}

/// Returns the less reliable of two statuses.
[[nodiscard]] constexpr TendonStatus worse(TendonStatus a, TendonStatus b) {
  return std::max(a, b);
}

/// Tensions in the slips of the extensor hood [N].
struct SlipTension {
  double central = 0, radial = 0, ulnar = 0, terminal = 0;
};

/// Torque of all tendons at one posture.
struct [[nodiscard]] TendonTorque {
  Eigen::VectorXd tau;     // joint torque of the tendons [N m] (coordinates)
  Eigen::MatrixXd R;       // moment arms: transpose of d tau / d tension, flexion positive [m/rad]
                           // (muscles, coordinates)
  SlipTension slips;       // zero without a hood
  Eigen::Matrix3Xd nodes;  // node positions of a net in equilibrium, world; start of the next
                           // evaluate() [m] (3, nodes)
  std::shared_ptr<const NetEquilibrium> rest;  // equilibrium of the net; null without a net
  // Muscles on elastic tendons: tensions [N] and line lengths [m] (muscles). Both are empty, and
  // `R` is set, where tensions are given.
  Eigen::VectorXd tension, length;
  long effort = 0;                             // number of evaluations of the net's energy
  std::string warning;                         // reason for a poor `status`, in words; may be empty
  TendonStatus status = TendonStatus::kValid;  // reliability, for decisions
};

/// Posture derivatives of linear tendons.
struct [[nodiscard]] TendonDerivatives {
  bool exist = true;           // false: a path or net is not differentiable here
  Eigen::MatrixXd by_posture;  // d tau / d q at given tensions [N m/rad] (coordinates, coordinates)
  Eigen::VectorXd length;      // length of each muscle's line, up to a constant [m] (muscles)
};

/// Posture derivatives of moment arms, for tendons whose torque is linear in the tensions: d tau /
/// d q at given tensions is the sum over muscles of these slopes times their tensions.
struct ArmSlopes {
  bool exist = true;        // false: a path is not differentiable here
  Eigen::MatrixXd of_pair;  // -d R_j / d q_k, symmetric part; row j + k (k + 1) / 2 with j <= k
                            // [m/rad^2] (pairs, muscles)
};

/// Computes moment arms of tendons without a net at many postures. It owns a workspace, which does
/// not affect results: use one object per thread.
class ArmSolver {
 public:
  virtual ~ArmSolver() = default;
  /// Overwrites R, warning and status of `out` with those of DigitTendons::evaluate(); other
  /// members keep their values.
  /// @throws InputError if q has a wrong length or an entry that is not finite.
  virtual void solve(const Eigen::VectorXd& q, TendonTorque& out) = 0;
  /// Overwrites `out` with the slopes of the arms. @throws InputError as solve().
  virtual void slopes(const Eigen::VectorXd& q, ArmSlopes& out) = 0;
};

/// Snap: a jump of a net to another equilibrium at one posture under the same tensions.
struct NetSnap {
  double share = 1;     // fraction of the way from the previous state at which it happened [1]
  std::string band;     // name of the band whose tension changed most
  double moved = 0;     // largest displacement of a node [m]
  double released = 0;  // energy lost by net and muscles; heat, since the net is massless [J]
};

/// Snaps and energy error of a net since the previous state.
struct NetStep {
  std::vector<NetSnap> snaps;  // in order of occurrence
  /// Change of the net's potential not explained by torque, line lengths or snaps [J].
  double unexplained = 0;
};

/// Derivatives of a digit whose muscles act through elastic tendons, by posture and by the position
/// of each tendon's far end.
struct EndSlopes {
  Eigen::MatrixXd torque_by_posture;   // [N m/rad] (coordinates, coordinates)
  Eigen::MatrixXd torque_by_end;       // [N] (coordinates, muscles)
  Eigen::MatrixXd tension_by_posture;  // [N/rad] (muscles, coordinates)
  Eigen::MatrixXd tension_by_end;      // [N/m] (muscles, muscles)
  Eigen::MatrixXd length_by_posture;   // derivative of line lengths [m/rad] (muscles, coordinates)
  Eigen::MatrixXd length_by_end;       // derivative of line lengths [1] (muscles, muscles)
};

/// Tendons of one digit in motion. The equilibrium of the net is followed continuously from the
/// last accepted state.
class TendonFollower {
 public:
  virtual ~TendonFollower() = default;

  /// Computes the torque at a state near the last accepted one. It is infinite where the net cannot
  /// be followed there, so that an integrator shortens its step. The first state is reached from
  /// the straight digit under the same tensions.
  /// @param load  tension of each muscle [N]; for DigitTendons::follower_on_tendons(), position of
  ///              the far end of its tendon [m] (muscles)
  /// @throws InputError as DigitTendons::evaluate().
  virtual TendonTorque torque_at(const Eigen::VectorXd& q, const Eigen::VectorXd& load) = 0;

  /// Returns whether the net snaps between the accepted state and the last one evaluated.
  [[nodiscard]] virtual bool snapped() const = 0;

  /// Accepts a state as the start of further steps.
  virtual NetStep accept(const Eigen::VectorXd& q, const Eigen::VectorXd& load) = 0;

  /// Computes the derivatives of the torque at (q, load); for muscles on elastic tendons only.
  [[nodiscard]] virtual EndSlopes slopes(const Eigen::VectorXd& /*q*/,
                                         const Eigen::VectorXd& /*load*/) {
    return {};
  }
};

/// Digit in equilibrium with its muscles on elastic tendons. Muscle and tendon together are as long
/// as the muscle's line, of length L: the tendon's length is  L - end.
struct TendonEnds {
  std::vector<std::shared_ptr<const TensionLaw>> laws;  // tension law of each tendon (muscles)
  const Eigen::VectorXd& q;                             // posture [rad] (coordinates)
  const Eigen::VectorXd& load;  // position of the far end of each tendon [m] (muscles)
  const TendonTorque& at;       // torque at q under the tensions of these laws
};

/// One digit with its tendons. Linear tendons have  tau = R' t;  with a net, tau is not linear in
/// t.
class DigitTendons {
 public:
  virtual ~DigitTendons() = default;

  /// Returns bones, names, limits and model fidelity of the digit.
  [[nodiscard]] virtual const TendonDigit& digit() const = 0;

  /// Computes torque, moment arms and status of all tendons.
  /// @param q      posture [rad] (coordinates)
  /// @param t      tension of each muscle, >= 0 [N] (muscles)
  /// @param start  initial node positions of a net, from a neighbouring posture; may be empty
  /// @throws InputError if a length is wrong, an entry not finite or a tension negative.
  virtual TendonTorque evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                const Eigen::Matrix3Xd& start) const = 0;

  /// Computes d tau / d q at given tensions: by derivatives() where they exist, otherwise by
  /// central differences of evaluate() [N m/rad] (coordinates, coordinates).
  /// @param at  evaluate() of this digit at the same q and t
  [[nodiscard]] virtual Eigen::MatrixXd torque_by_posture(const Eigen::VectorXd& q,
                                                          const Eigen::VectorXd& t,
                                                          const TendonTorque& at) const;

  /// Computes the compliance of the tendons, -d length / d tension: symmetric, positive
  /// semidefinite; 0 without a net, whose bands stretch [m/N] (muscles, muscles).
  /// The last argument is evaluate() of this digit at the same q and t.
  [[nodiscard]] virtual Eigen::MatrixXd compliance(const Eigen::VectorXd& /*q*/,
                                                   const Eigen::VectorXd& t,
                                                   const TendonTorque& /*at*/) const {
    return Eigen::MatrixXd::Zero(t.size(), t.size());
  }

  /// Computes the length of each muscle's line, up to a constant [m] (muscles): the sum of the
  /// lengths of its strands, each weighted with the share of tension that it carries. Where shares
  /// are constant and sheaths frictionless,  d length/dq = -R  at constant tensions.
  /// @param at  evaluate() of this digit at the same q and t
  [[nodiscard]] virtual Eigen::VectorXd lengths(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                                const TendonTorque& at) const = 0;

  /// Returns a copy whose net bands change from slack to taut smoothly over this strain; null
  /// without a net.
  /// @throws InputError if the strain is negative or not finite.
  [[nodiscard]] virtual std::unique_ptr<DigitTendons> smoothed(double /*strain*/) const {
    return nullptr;
  }

  /// Returns an object that follows the net from state to state and must not outlive these tendons;
  /// null without a net.
  [[nodiscard]] virtual std::unique_ptr<TendonFollower> follower() const { return nullptr; }

  /// Returns an object that follows the net from an equilibrium under muscles on elastic tendons:
  /// net and tendons minimise their common energy. Null without a net, where a muscle pulls more
  /// than one of its bands or has friction in its sheath, and where `ends.at` holds no equilibrium.
  [[nodiscard]] virtual std::unique_ptr<TendonFollower> follower_on_tendons(
      const TendonEnds& /*ends*/) const {
    return nullptr;
  }

  /// Computes derivatives and lengths of tendons without a net, in closed form. Lengths are those
  /// of lengths(), without friction in sheaths.
  /// @throws InputError as evaluate().
  [[nodiscard]] virtual TendonDerivatives derivatives(const Eigen::VectorXd& /*q*/,
                                                      const Eigen::VectorXd& /*t*/) const {
    return {false, {}, {}};
  }

  /// Returns a solver for moment arms, which must not outlive these tendons; null where only
  /// evaluate() computes them.
  [[nodiscard]] virtual std::unique_ptr<ArmSolver> arm_solver() const { return nullptr; }

  TendonTorque evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& t) const {
    return evaluate(q, t, {});
  }
};

// Lengthening of muscles from one posture to another.

/// Lengthening of each muscle-tendon unit, with a warning where it is unreliable.
struct [[nodiscard]] Excursion {
  Eigen::VectorXd e;    // lengthening [m] (muscles)
  std::string warning;  // first warning on the way; may be empty
};

/// Computes the excursion  e = - integral of R dq  along the straight line between two postures, by
/// the five-point Gauss rule on pieces of at most 0.1 rad. Where R is a gradient (separate tendons,
/// constant shares) the result does not depend on the line. For a net, and for shares that change
/// with posture, it is the rate at which the torque takes up a muscle's power; the stretch of the
/// net's own bands is left out.
/// @param t  tensions at which R is evaluated [N] (muscles)
Excursion excursion(const DigitTendons& tendons, const Eigen::VectorXd& from,
                    const Eigen::VectorXd& to, const Eigen::VectorXd& t);

}  // namespace thenar
