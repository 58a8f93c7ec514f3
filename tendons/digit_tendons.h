#pragma once

/// Torque of tendon tensions on one digit, for every rung of path and hood.

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

/// Reliability of the torque of tendons, from good to bad.
enum class TendonStatus {
  kValid,           // paths are taut, a net is at equilibrium at a minimum
  kApproximate,     // fitted arms may be off by more than 1 mm/rad, or an origin rides on a bend
  kBandInsideBone,  // a band in tension ends inside the bone over which it bends
  kNodeCollapsed,   // a muscle has pulled a knot to its exit: the net does not hold it, or takes
                    // part of the pull
  kOutOfRange,      // fitted paths are asked outside of their joints' ranges, where they run wild
  kInvalidPath,     // a wrapped path is not taut, has a point in bone or went round the far side
  kUnstable,        // a net at a saddle: any disturbance moves it elsewhere
  kOverstrained,    // a net balanced by bands that bear more than tissue can
  kUnbalanced       // a net without equilibrium: its torques are those of no balance
};

/// Returns whether results may be used in computations: up to kBandInsideBone.
[[nodiscard]] constexpr bool trusted(TendonStatus status) {
  return status < TendonStatus::kNodeCollapsed;
}

[[nodiscard]] constexpr TendonStatus worse(TendonStatus a, TendonStatus b) {
  return std::max(a, b);
}

/// Tension in the slips of the extensor hood [N].
struct SlipTension {
  double central = 0, radial = 0, ulnar = 0, terminal = 0;
};

/// Torque of all tendons at one posture.
struct [[nodiscard]] TendonTorque {
  Eigen::VectorXd tau;     // joint torque of the tendons [N m] (coordinates)
  Eigen::MatrixXd R;       // d tau / d tension, transposed: moment arms, flexion + (muscles,
                           // coordinates) [m/rad]
  SlipTension slips;       // zero without a hood
  Eigen::Matrix3Xd nodes;  // of a net at rest, world; hand it on as the next start [m] (3, nodes)
  std::shared_ptr<const NetEquilibrium> rest;  // equilibrium of the net; null without a net
  Eigen::VectorXd tension, length;  // of muscles on tendons that stretch [N], [m] (muscles); empty:
                                    // their tensions are given. `R` is empty where these are not
  long effort = 0;                  // evaluations of a net's energy that it took
  std::string warning;              // why not to trust it; may be empty
  TendonStatus status = TendonStatus::kValid;  // the same, for decisions
};

/// Derivatives of linear tendons by posture.
struct [[nodiscard]] TendonDerivatives {
  bool exist = true;           // false: a path or net is not differentiable here
  Eigen::MatrixXd by_posture;  // d tau/dq at given tensions [N m/rad] (coordinates, coordinates)
  Eigen::VectorXd length;      // of each muscle's line, up to a constant [m] (muscles)
};

/// Slopes of moment arms by posture, for tendons that are linear in tensions: d tau / d q  at given
/// tensions is the sum of these slopes over muscles, each times its tension.
struct ArmSlopes {
  bool exist = true;        // false: a path is not differentiable here
  Eigen::MatrixXd of_pair;  // -d R_j / d q_k, symmetric part, pair j + k (k + 1) / 2 with j <= k
                            // [m/rad^2] (pairs, muscles)
};

/// Moment arms of tendons without a net, posture after posture. It holds the room of one thread,
/// which changes no answer.
class ArmSolver {
 public:
  virtual ~ArmSolver() = default;
  /// Writes R, warning and status of DigitTendons::evaluate() over those of `out`, nothing else.
  /// @throws InputError if q has a wrong length or an entry that is not finite.
  virtual void solve(const Eigen::VectorXd& q, TendonTorque& out) = 0;
  /// Writes slopes of the arms over those of `out`. @throws InputError as solve().
  virtual void slopes(const Eigen::VectorXd& q, ArmSlopes& out) = 0;
};

/// A jump of a net to another equilibrium at one posture under the same tensions.
struct NetSnap {
  double share = 1;     // of the way since the state before at which it happened [1]
  std::string band;     // whose tension changed most
  double moved = 0;     // furthest way of a knot [m]
  double released = 0;  // energy that net and muscles lost, as heat, as a net has no mass [J]
};

/// Snaps and potential error of a net since the state before.
struct NetStep {
  std::vector<NetSnap> snaps;  // the first one first
  double unexplained = 0;      // potential of the net that neither its torque and lengths nor its
                               // snaps account for [J]
};

/// Slopes of a digit whose muscles hang on tendons that stretch, by posture and by the ends of
/// these tendons.
struct EndSlopes {
  Eigen::MatrixXd torque_by_posture;   // [N m/rad] (coordinates, coordinates)
  Eigen::MatrixXd torque_by_end;       // [N] (coordinates, muscles)
  Eigen::MatrixXd tension_by_posture;  // [N/rad] (muscles, coordinates)
  Eigen::MatrixXd tension_by_end;      // [N/m] (muscles, muscles)
  Eigen::MatrixXd length_by_posture;   // of the muscles' lines [m/rad] (muscles, coordinates)
  Eigen::MatrixXd length_by_end;       // [1] (muscles, muscles)
};

/// Tendons of one digit in motion, whose net is where it came to from the state accepted last.
class TendonFollower {
 public:
  virtual ~TendonFollower() = default;

  /// Torque at a state near the one accepted last; its torque is infinite where the net could not
  /// be followed there, so that whoever asks comes nearer. The first one comes from the straight
  /// digit under the same tensions.
  /// @param load  tension of each muscle [N], or, of DigitTendons::follower_on_tendons(), end of
  /// its
  ///              tendon [m] (muscles)
  /// @throws InputError as DigitTendons::evaluate().
  virtual TendonTorque at(const Eigen::VectorXd& q, const Eigen::VectorXd& load) = 0;

  /// Returns whether the net snaps on its way to the state last asked for.
  [[nodiscard]] virtual bool snapped() const = 0;

  /// Accepts a state, from which the net is followed on.
  virtual NetStep accept(const Eigen::VectorXd& q, const Eigen::VectorXd& load) = 0;

  /// Slopes at at(q, load), of muscles on tendons.
  [[nodiscard]] virtual EndSlopes slopes(const Eigen::VectorXd& /*q*/,
                                         const Eigen::VectorXd& /*load*/) {
    return {};
  }
};

/// A digit at rest with its muscles on tendons that stretch. A line L is taken up by muscle and
/// tendon: its tendon is  L - end  long.
struct TendonEnds {
  std::vector<std::shared_ptr<const TensionLaw>> laws;  // of each tendon (muscles)
  const Eigen::VectorXd& q;                             // [rad] (coordinates)
  const Eigen::VectorXd& load;                          // end of each tendon [m] (muscles)
  const TendonTorque& at;                               // there, under the tensions of these laws
};

/// One digit with its tendons. On linear rungs  tau = R' t;  with a net tau is not linear in t.
class DigitTendons {
 public:
  virtual ~DigitTendons() = default;

  /// Bones, names, limits and what was built.
  [[nodiscard]] virtual const TendonDigit& digit() const = 0;

  /// Torque, moment arms and state of all tendons.
  /// @param q      posture [rad] (coordinates)
  /// @param t      tension of each muscle, >= 0 [N] (muscles)
  /// @param start  nodes of a net at a neighbouring posture, to start from; may be empty
  /// @throws InputError if a length is wrong, an entry not finite or a tension negative.
  virtual TendonTorque evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                const Eigen::Matrix3Xd& start) const = 0;

  /// d tau / d q at these tensions: by derivatives() where it exists, otherwise by central
  /// differences of evaluate() [N m/rad] (coordinates, coordinates).
  /// @param at  evaluate() of this digit at these very q and t
  [[nodiscard]] virtual Eigen::MatrixXd torque_by_posture(const Eigen::VectorXd& q,
                                                          const Eigen::VectorXd& t,
                                                          const TendonTorque& at) const;

  /// Compliance of the tendons at this posture, -d length / d tension, symmetric, with no negative
  /// eigenvalue; 0 without a net, whose bands stretch [m/N] (muscles, muscles).
  /// The last argument is evaluate() of this digit at these very q and t.
  [[nodiscard]] virtual Eigen::MatrixXd compliance(const Eigen::VectorXd& /*q*/,
                                                   const Eigen::VectorXd& t,
                                                   const TendonTorque& /*at*/) const {
    return Eigen::MatrixXd::Zero(t.size(), t.size());
  }

  /// Length of each muscle's line, up to a constant [m] (muscles). A muscle's length is that of
  /// its strands, each weighted with the share of tension that it carries. Where shares are
  /// constant and sheaths smooth,  d length/dq = -R  while tensions stay.
  /// @param at  evaluate() of this digit at these very q and t
  [[nodiscard]] virtual Eigen::VectorXd lengths(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                                const TendonTorque& at) const = 0;

  /// A copy whose net bands go from slack to taut smoothly over this strain; null without a net.
  /// @throws InputError if it is negative or not finite.
  [[nodiscard]] virtual std::unique_ptr<DigitTendons> smoothed(double /*strain*/) const {
    return nullptr;
  }

  /// Follows a net from state to state, for as long as this lives; null without a net.
  [[nodiscard]] virtual std::unique_ptr<TendonFollower> follower() const { return nullptr; }

  /// Follows a net from a rest under muscles on tendons that stretch: both rest in the least of one
  /// energy. Null without a net, where a muscle pulls more than one of its bands or its sheath
  /// rubs, and where `ends.at` states no rest.
  [[nodiscard]] virtual std::unique_ptr<TendonFollower> follower_on_tendons(
      const TendonEnds& /*ends*/) const {
    return nullptr;
  }

  /// Derivatives and lengths of tendons without a net, in closed form. A muscle's length is that of
  /// strands, each weighted with the share of tension that it carries; friction in sheaths is left
  /// out of it. Where shares are constant and sheaths smooth,  d length/dq = -R.
  /// @throws InputError as evaluate().
  [[nodiscard]] virtual TendonDerivatives derivatives(const Eigen::VectorXd& /*q*/,
                                                      const Eigen::VectorXd& /*t*/) const {
    return {false, {}, {}};
  }

  /// Arms posture after posture, for as long as this lives; null: evaluate() does.
  [[nodiscard]] virtual std::unique_ptr<ArmSolver> arm_solver() const { return nullptr; }

  TendonTorque evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& t) const {
    return evaluate(q, t, {});
  }
};

// Lengthening of muscles from one posture to another.

/// Lengthening of each muscle-tendon unit, and how far it can be trusted.
struct [[nodiscard]] Excursion {
  Eigen::VectorXd e;    // lengthening [m] (muscles)
  std::string warning;  // the first on the way, why not to trust it; may be empty
};

/// Excursion  e = - integral of R dq  along the straight line between two postures, by Gauss's rule
/// of five points on pieces of at most 0.1 rad. Where R is a gradient (separate tendons, constant
/// shares) the line does not matter. That of a net, and of shares that change with posture, is the
/// rate at which its torque takes up a muscle's power; the stretch of its own bands is left out.
/// @param t  tensions at which R is taken [N] (muscles)
Excursion excursion(const DigitTendons& tendons, const Eigen::VectorXd& from,
                    const Eigen::VectorXd& to, const Eigen::VectorXd& t);

}  // namespace thenar
