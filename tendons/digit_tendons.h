#pragma once

/// What tendon tensions do to one digit, whatever the rungs of path and hood.

#include <algorithm>
#include <memory>
#include <string>

#include <Eigen/Core>

#include "base/error.h"
#include "tendons/tendon_model.h"

namespace thenar {

struct NetEquilibrium;

/// How far to believe what tendons do, from good to bad.
enum class TendonStatus {
  kValid,           // paths are taut, a net is at rest at a minimum
  kApproximate,     // fitted arms may be off by more than 1 mm/rad, or an origin rides on a bend
  kBandInsideBone,  // a band in tension ends inside the bone over which it bends
  kNodeCollapsed,   // a muscle has drawn a knot into its exit: the net does not hold it
  kOutOfRange,      // fitted paths are asked outside of their joints' ranges, where they run wild
  kInvalidPath,     // a wrapped path is not taut, has a point in bone or went round the far side
  kUnstable,        // a net at a saddle: the least push moves it elsewhere
  kUnbalanced       // a net without rest: its torques are those of no balance
};

/// Whether numbers may be built upon: up to kBandInsideBone.
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
  std::shared_ptr<const NetEquilibrium> rest;  // of a net; null: there is none
  std::string warning;                         // why not to trust this, in words; empty: nothing
  TendonStatus status = TendonStatus::kValid;  // the same, for decisions
};

/// How linear tendons change with posture.
struct [[nodiscard]] TendonDerivatives {
  bool exist = true;           // false: a path or net has no slopes here
  Eigen::MatrixXd by_posture;  // d tau/dq at given tensions [N m/rad] (coordinates, coordinates)
  Eigen::VectorXd length;      // of each muscle's line, but for a constant [m] (muscles)
};

/// One digit with its tendons. Linear rungs have  tau = R' t; a net has not.
class DigitTendons {
 public:
  virtual ~DigitTendons() = default;

  /// Bones, names, limits and what was built.
  [[nodiscard]] virtual const TendonDigit& digit() const = 0;

  /// @param q      posture [rad] (coordinates)
  /// @param t      tension of each muscle, >= 0 [N] (muscles)
  /// @param start  nodes of a net to start from: of a neighbouring posture; empty: none
  /// @throws InputError if a length is wrong, an entry not finite or a tension negative.
  virtual TendonTorque pull(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                            const Eigen::Matrix3Xd& start) const = 0;

  /// d tau / d q at these tensions: slopes() where there are some, else central differences of
  /// pull() [N m/rad] (coordinates, coordinates).
  /// @param at  pull() of this digit at these very q and t
  [[nodiscard]] virtual Eigen::MatrixXd torque_by_posture(const Eigen::VectorXd& q,
                                                          const Eigen::VectorXd& t,
                                                          const TendonTorque& at) const;

  /// How far tendons give at this posture, -d length / d tension, symmetric, with no negative
  /// eigenvalue; 0 but for a net, whose bands stretch [m/N] (muscles, muscles).
  /// @param at  pull() of this digit at these very q and t
  [[nodiscard]] virtual Eigen::MatrixXd give(const Eigen::VectorXd& /*q*/, const Eigen::VectorXd& t,
                                             const TendonTorque& /*at*/) const {
    return Eigen::MatrixXd::Zero(t.size(), t.size());
  }

  /// Length of each muscle's line, but for a constant [m] (muscles). A muscle's length is that of
  /// its strands, each weighted with the share of tension that it carries. Where shares are
  /// constant and sheaths smooth,  d length/dq = -R  while tensions stay.
  /// @param at  pull() of this digit at these very q and t
  [[nodiscard]] virtual Eigen::VectorXd lengths(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                                const TendonTorque& at) const = 0;

  /// The same digit with bands of a net that go from slack to taut over this strain, so that its
  /// torque is smooth where they do; null where there is no net.
  /// @throws InputError if it is negative or not finite.
  [[nodiscard]] virtual std::unique_ptr<DigitTendons> blended(double /*strain*/) const {
    return nullptr;
  }

  /// Slopes and lengths of tendons without a net, analytically. A muscle's length is that of its
  /// strands, each weighted with the share of tension that it carries; friction in sheaths is left
  /// out of it. Where shares are constant and sheaths smooth,  d length/dq = -R.
  /// @throws InputError as pull().
  [[nodiscard]] virtual TendonDerivatives slopes(const Eigen::VectorXd& /*q*/,
                                                 const Eigen::VectorXd& /*t*/) const {
    return {false, {}, {}};
  }

  TendonTorque pull(const Eigen::VectorXd& q, const Eigen::VectorXd& t) const {
    return pull(q, t, {});
  }
};

// How much muscles lengthen from one posture to another.

/// Change of length, and whether to believe it.
struct [[nodiscard]] Excursion {
  Eigen::VectorXd e;    // lengthening [m] (muscles)
  std::string warning;  // the first on the way, why not to trust this; empty: nothing
};

/// Excursion  e = - integral of R dq  along the straight line between two postures, by Gauss's rule
/// of five points on pieces of at most 0.1 rad. Where R is a gradient (separate tendons, constant
/// shares) the line does not matter. That of a net, and of shares that change with posture, is the
/// rate at which its torque takes up a muscle's power; the stretch of its own bands is left out.
/// @param t  tensions at which R is taken [N] (muscles)
Excursion excursion(const DigitTendons& tendons, const Eigen::VectorXd& from,
                    const Eigen::VectorXd& to, const Eigen::VectorXd& t);

}  // namespace thenar
