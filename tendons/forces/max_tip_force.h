#pragma once

/// The largest static force or wrench of a fingertip, by linear programming.

#include <Eigen/Core>

#include "base/numbers.h"
#include "base/spatial.h"
#include "solvers/status.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Residuals of an answer; not a number unless solved.
struct MaxTipForceCheck {
  double gap = kUnknown;        // no force in the cone has a component larger by more    [N]
  double outside = kUnknown;    // of the force beyond the cone, across the direction     [N]
  double imbalance = kUnknown;  // largest of |J' f - R' t - tau_0|                       [N m]

  static constexpr double kUnknown = kNaN;
};

/// Shadow prices: how much more force one newton more of a muscle's F0 gives.
struct ForceLimitPrices {
  Eigen::VectorXd increase;  // d component / d F0 as it grows, 0: does not limit; empty: not asked
                             // for, or not verified                                  [N/N] (m)
  Eigen::VectorXd
      decrease;             // the same as it shrinks; larger where several limits meet (degenerate)
                            // infinite: no such force is left; NaN: not found       [N/N] (m)
  double gap = kNaN;        // |component - sum price F0 - p' tau_0|, p the prices of torque [N]
  double slackness = kNaN;  // sum of each price times the room to its limit         [N]
  double dual_violation = kNaN;  // of p: force that no limit pays for                [1]

  /// Returns whether prices of an increase and of a decrease differ.
  [[nodiscard]] bool degenerate() const;
};

struct MaxTipForce {
  Status status;               // read this first
  Eigen::Vector3d force;       // of the tip on the world, world frame           [N] (3)
  double component;            // of `force` along the direction, d' f: what is maximised; with a
                               // tolerance |force| may be larger; infinite if unbounded [N]
  Eigen::VectorXd tension;     // that makes it                                  [N] (m)
  Eigen::VectorXd activation;  // tension / F0, 0 where F0 is infinite or zero   [1] (m)
  Eigen::VectorXd torque_shadow_price;  // d component / d tau_0; zero unless solved      [1/m] (n)
  MaxTipForceCheck check;               // by weak duality and from J, R themselves
  ForceLimitPrices prices{};            // where they were asked for
};

struct MaxTipForceOptions {
  double tolerance = 0;  // half angle of the cone about the direction, in [0, pi/2)  [rad]
  bool prices = false;   // also find the prices of F0
};

/// The largest force of a pinned tip along a direction:
///
///   maximise d' f  subject to  J' f = R' t + tau_0,  0 <= t <= F0,  angle(f, d) <= tolerance.
///
/// Every joint torque is balanced; the tip carries no moment. With a tolerance the cone is met
/// to 1e-10 of the force (or 1e-11 of what tendons make, if that is more) by cutting planes. A
/// straight finger carries any force along itself: that is `kUnbounded`, not a large number.
/// Of equal optima the one is returned of which bones carry least alone: in the plane of parallel
/// axes a cone gives no force across it. The planes hold the whole cone, so the dual bound of the
/// last program bounds every force in it: that is `check.gap`.
///
/// Prices of F0 are those of the linear program's upper bounds, the least and the largest of all
/// optimal duals (upper_bound_prices()). They are returned only if p, the prices of joint torque,
/// pass three checks from J and R themselves, to 1e-7 of the force: no force of the cone and no
/// tension has a better price than its limit pays (dual feasibility), what has room to its limit
/// has no price (complementary slackness), and component = sum price F0 + p' tau_0 (strong
/// duality).
///
/// @param statics    one posture; W is not looked at
/// @param direction  wanted direction of the force, any length but zero   3   [1]
/// @throws InputError if the statics are inconsistent or not finite, the direction is zero or not
///         finite, or the tolerance is outside its range.
/// Source: [ValeroCuevas1998]; the cutting planes are Kelley's [Kelley1960].
[[nodiscard]] MaxTipForce max_tip_force(const TipStatics& statics, const Eigen::Vector3d& direction,
                                        const MaxTipForceOptions& options = {});

struct MaxTipWrench {
  Status status;               // read this first
  double multiple;             // of the wrench asked for; infinite if unbounded [1]
  Eigen::VectorXd tension;     // that makes it                                  [N] (m)
  Eigen::VectorXd activation;  // tension / F0, 0 where F0 is infinite or zero   [1] (m)
  double gap;                  // no multiple exceeds this one by more; NaN unless solved [1]
};

/// The largest multiple of a wrench that a tip can hold, all other components zero:
///
///   maximise s >= 0  subject to  s (J' f + W' m) = R' t + tau_0,  0 <= t <= F0.
///
/// @param statics  one posture; W may be absent if the moment is zero
/// @param wrench   m about the tip, and f; world frame [N m], [N]
/// @throws InputError as max_tip_force(), or if a moment is wanted and W is absent.
/// Source: [ValeroCuevas1998].
[[nodiscard]] MaxTipWrench max_tip_wrench(const TipStatics& statics, const Wrench& wrench);

}  // namespace thenar
