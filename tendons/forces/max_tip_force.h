#pragma once

/// The largest static force or wrench of a fingertip, by linear programming.

#include <Eigen/Core>

#include "base/numbers.h"
#include "base/spatial.h"
#include "solvers/status.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// What is left between an answer and the truth; not a number unless solved.
struct MaxTipForceCheck {
  double gap = kUnknown;        // no force in the cone exceeds magnitude by more         [N]
  double outside = kUnknown;    // of the force beyond the cone, across the direction     [N]
  double imbalance = kUnknown;  // largest of |J' f - R' t - tau_0|                       [N m]

  static constexpr double kUnknown = kNaN;
};

struct MaxTipForce {
  Status status;               // read this first
  Eigen::Vector3d force;       // of the tip on the world, world frame           [N] (3)
  double magnitude;            // its component along the direction; infinite if unbounded [N]
  Eigen::VectorXd tension;     // that makes it                                  [N] (m)
  Eigen::VectorXd activation;  // tension / F0, 0 where F0 is infinite or zero   [1] (m)
  Eigen::VectorXd torque_shadow_price;  // d magnitude / d tau_0; zero unless solved      [1/m] (n)
  MaxTipForceCheck check;               // by weak duality and from J, R themselves
};

struct MaxTipForceOptions {
  double tolerance = 0;  // half angle of the cone about the direction, in [0, pi/2)  [rad]
};

/// The largest force of a pinned tip along a direction:
///
///   maximise d' f  subject to  J' f = R' t + tau_0,  0 <= t <= F0,  angle(f, d) <= tolerance.
///
/// Every joint torque is balanced; the tip carries no moment. With a tolerance the cone is met
/// to 1e-10 of the force (or 1e-11 of what tendons make, if that is more) by cutting planes. A
/// straight finger carries any force along itself: that is `kUnbounded`, not a large number.
/// The planes hold the whole cone, so the dual bound of the last program bounds every force in it:
/// that is `check.gap`.
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
