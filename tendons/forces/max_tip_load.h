#pragma once

/// The largest force or moment of a fingertip whose other load is zero, bounded or free.

#include <vector>

#include <Eigen/Core>

#include "base/numbers.h"
#include "tendons/forces/feasible_force_set.h"
#include "tendons/forces/max_tip_force.h"
#include "tendons/forces/posture_sensitivity.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Load of a tip on the world.
enum class TipLoad { kForce, kMoment };

/// A joint at the end of its range: capsule and ligaments hold it from going further, and give no
/// torque the other way:  0 <= torque / most <= 1.
struct JointStop {
  int coordinate;  // which joint
  double most;     // largest torque, with the sign of the torque: positive flexes, as at the end of
                   // extension; may be infinite                                            [N m]
};

/// Options of max_tip_load(): the load to maximise and the bounds of the other load, moments beside
/// a force, forces beside a moment.
struct TipLoadOptions {
  TipLoad load = TipLoad::kForce;
  double tolerance = 0;   // half angle of the cone about the direction, in [0, pi/2)       [rad]
  double most_other = 0;  // of each component of the other load: 0 is a pinned tip (force) or a
                          // pure moment, infinity a rigid hold                       [N m] or [N]
  Eigen::Matrix3d axes =
      Eigen::Matrix3d::Identity();  // columns: axes of those components, world frame      (3, 3)
  bool prices = false;              // also find the prices of F0
  std::vector<JointStop> stops{};   // joints that stand at the end of their range
};

/// The answer; where a moment is maximised, [N] of MaxTipForce reads [N m].
struct MaxTipLoad {
  MaxTipForce largest;    // the load that is maximised; its check by the balance below
  Eigen::Vector3d other;  // the other load, world frame                       [N m] or [N] (3)
  Eigen::VectorXd stop_torque{};  // of each stop, positive flexes                    [N m] (stops)
  Eigen::VectorXd stop_price{};   // d component / d |most| of each stop as it grows, 0: it does not
                                  // limit; empty: not asked for, or not verified [N/(N m)] (stops)
};

/// The largest load of a tip along a direction, every joint in balance:
///
///   maximise d' a  subject to  A' a + B' b = R' t + s + tau_0,  0 <= t <= F0,
///                              angle(a, d) <= tolerance,  |axes' b| <= most_other,
///
/// with (A, B) = (J, W) and (a, b) = (f, m) for a force, and the other way round for a moment; s
/// are the torques of `stops`, which are further tendons of one joint each: unilateral constraints.
/// Other loads of zero are left out. Free ones are eliminated: with N an orthonormal basis of the
/// torques that no b makes (B N = 0), the balance is  N' A' a = N' (R' t + tau_0),  and b is the
/// least that makes the rest. Bounded ones are pairs of further tendons along the axes. What is
/// left is the program of max_tip_force(), whose certificate and prices hold. Moments are counted
/// in newtons at 10 mm there, so that its thresholds mean the same.
///
/// @param statics    one posture; W is needed unless the load is a force and most_other is zero
/// @param direction  wanted direction of the load, any length but zero   3   [1]
/// @throws InputError as max_tip_force(), if W is needed and absent, if most_other is negative or
///         not a number, or if a stop is of no joint or has no torque.
/// Source: [ValeroCuevas1998] for the wrench of a fingertip.
[[nodiscard]] MaxTipLoad max_tip_load(const TipStatics& statics, const Eigen::Vector3d& direction,
                                      const TipLoadOptions& options = {});

/// All forces, or all moments, that the tip can make under the same balance: [N] of
/// FeasibleForceSet then reads [N m]. See max_tip_load() and feasible_force_set().
[[nodiscard]] FeasibleForceSet feasible_load_set(const TipStatics& statics,
                                                 const TipLoadOptions& options);

/// Derivative of max_tip_load()'s component by every coordinate, with the prices p of joint torque:
///
///   p' (dtau_0 + dR' t - dA' a - dB' b),  and  - p' (A' (W_k x a) + B' (W_k x b))
///
/// with stops as they are; the second part if direction and axes turn with the tip. At a degenerate
/// vertex prices are one choice of many and the derivative holds to one side.
/// @param largest  solved, of `statics`
/// @return (n) [N/rad] or [N m/rad]
[[nodiscard]] Eigen::VectorXd max_tip_load_gradient(const TipStatics& statics,
                                                    const std::vector<StaticsDerivative>& slopes,
                                                    const MaxTipLoad& largest, TipLoad load,
                                                    DirectionFrame frame);

}  // namespace thenar
