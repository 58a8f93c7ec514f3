#pragma once

/// Largest static force or wrench of a fingertip, by linear programming.

#include <Eigen/Core>

#include "base/numbers.h"
#include "base/spatial.h"
#include "solvers/status.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Residuals of a solution; NaN unless solved.
struct MaxTipForceCheck {
  /// Duality gap: bound of how much larger a component in the cone can be [N].
  double gap = kUnknown;
  double outside = kUnknown;    // distance of the force outside the cone, across the direction [N]
  double imbalance = kUnknown;  // largest of |J' f - R' t - tau_0| [N m]

  static constexpr double kUnknown = kNaN;
};

/// Shadow prices: change of the force per newton of a muscle's F0.
struct ForceLimitPrices {
  Eigen::VectorXd increase;  // d component / d F0 as F0 grows, 0: not limiting; empty: not
                             // requested, or not verified [N/N] (m)
  /// d component / d F0 as F0 shrinks; larger where several limits meet (degenerate). Infinite: no
  /// such force is left; NaN: not found [N/N] (m)
  Eigen::VectorXd decrease;
  double gap = kNaN;        // |component - sum price F0 - p' tau_0|, p the prices of torque [N]
  double slackness = kNaN;  // sum of each price times the slack of its bound [N]
  double dual_violation = kNaN;  // dual infeasibility of p: force not covered by any bound [1]

  /// Returns whether prices of an increase and of a decrease differ.
  [[nodiscard]] bool degenerate() const;
};

/// Result of max_tip_force().
struct MaxTipForce {
  Status status = Status::kStalled;  // read this first
  Eigen::Vector3d force;             // force of the tip on the world, world frame [N] (3)
  double component = 0;  // component of `force` along the direction, d' f, which is maximised; with
                         // a tolerance |force| may be larger; infinite if unbounded [N]
  Eigen::VectorXd tension;              // tensions that produce it [N] (m)
  Eigen::VectorXd activation;           // tension / F0, 0 where F0 is infinite or zero [1] (m)
  Eigen::VectorXd torque_shadow_price;  // d component / d tau_0; zero unless solved [1/m] (n)
  MaxTipForceCheck check;               // residuals, by weak duality and from J and R themselves
  ForceLimitPrices prices{};            // prices of F0, if requested
};

/// Options of max_tip_force().
struct MaxTipForceOptions {
  double tolerance = 0;  // half angle of the cone about the direction, in [0, pi/2) [rad]
  bool prices = false;   // true: also compute the prices of F0
};

/// Computes the largest force of a pinned tip along a direction:
///
///   maximise d' f  subject to  J' f = R' t + tau_0,  0 <= t <= F0,  angle(f, d) <= tolerance.
///
/// Every joint torque is balanced; the tip carries no moment. With a tolerance the cone is met to
/// 1e-10 of the force (or 1e-11 of the force that tendons can produce, if larger) by cutting
/// planes. A straight finger carries any force along itself: that is `kUnbounded`, not a large
/// number. Among equal optima the result has the smallest part that bones carry alone: in the plane
/// of parallel axes a cone gives no force across it. The planes contain the whole cone, so the dual
/// bound of the last program bounds every force in it: that is `check.gap`.
///
/// Prices of F0 are those of the linear program's upper bounds, the smallest and the largest of all
/// optimal duals (upper_bound_prices()). They are returned only if p, the prices of joint torque,
/// pass three checks from J and R themselves, to 1e-7 of the force: no force of the cone and no
/// tension has a larger price than its bound (dual feasibility), bounds with slack have no price
/// (complementary slackness), and component = sum price F0 + p' tau_0 (strong duality).
///
/// @param statics    one posture; W is not used
/// @param direction  wanted direction of the force, any length but zero   3   [1]
/// @throws InputError if the statics are inconsistent or not finite, the direction is zero or not
/// finite, or the tolerance is outside its range.
/// Source: [ValeroCuevas1998]; the cutting planes are Kelley's [Kelley1960].
[[nodiscard]] MaxTipForce max_tip_force(const TipStatics& statics, const Eigen::Vector3d& direction,
                                        const MaxTipForceOptions& options = {});

/// Result of max_tip_wrench().
struct MaxTipWrench {
  Status status = Status::kStalled;  // read this first
  double multiple = 0;               // multiple of the given wrench; infinite if unbounded [1]
  Eigen::VectorXd tension;           // tensions that produce it [N] (m)
  Eigen::VectorXd activation;        // tension / F0, 0 where F0 is infinite or zero [1] (m)
  /// Duality gap: bound of how much larger the multiple can be; NaN unless solved [1].
  double gap = kNaN;
};

/// Computes the largest multiple of a wrench that a tip can hold, all other components zero:
///
///   maximise s >= 0  subject to  s (J' f + W' m) = R' t + tau_0,  0 <= t <= F0.
///
/// @param statics  one posture; W may be absent if the moment is zero
/// @param wrench   m about the tip, and f; world frame [N m], [N]
/// @throws InputError as max_tip_force(), or if a moment is wanted and W is absent.
/// Source: [ValeroCuevas1998].
[[nodiscard]] MaxTipWrench max_tip_wrench(const TipStatics& statics, const Wrench& wrench);

}  // namespace thenar
