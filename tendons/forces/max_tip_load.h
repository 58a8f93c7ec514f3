#pragma once

/// Largest force or moment of a fingertip whose other load is zero, bounded or free.

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

/// Joint at the end of its range. Capsule and ligaments prevent further rotation, and exert no
/// torque in the other sense:  0 <= torque / max_torque <= 1.
struct JointStop {
  int coordinate = 0;     // index of the joint's coordinate
  double max_torque = 0;  // largest torque, with its sign: positive flexes, as at the end of
                          // extension; may be infinite [N m]
};

/// Options of max_tip_load(): the load to maximise and the bounds of the other load, moments beside
/// a force, forces beside a moment.
struct TipLoadOptions {
  TipLoad load = TipLoad::kForce;
  double tolerance = 0;  // half angle of the cone about the direction, in [0, pi/2) [rad]
  double max_other = 0;  // bound of each component of the other load: 0 is a pinned tip (force) or
                         // a pure moment, infinity a rigid hold [N m] or [N]
  /// Columns: axes of those components, world frame (3, 3).
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  bool prices = false;             // true: also compute the prices of F0
  std::vector<JointStop> stops{};  // joints at the end of their range
};

/// Result of max_tip_load(); where a moment is maximised, [N] of MaxTipForce means [N m].
struct MaxTipLoad {
  MaxTipForce largest;            // maximised load; its check uses the balance below
  Eigen::Vector3d other;          // the other load, world frame [N m] or [N] (3)
  Eigen::VectorXd stop_torque{};  // torque of each stop, positive flexes [N m] (stops)
  /// Derivative of the component by |max_torque| of each stop as it grows, 0: not limiting; empty:
  /// not requested, or not verified [N/(N m)], of a moment [1] (stops).
  Eigen::VectorXd stop_price{};
};

/// Computes the largest load of a tip along a direction, every joint in balance:
///
///   maximise d' a  subject to  A' a + B' b = R' t + s + tau_0,  0 <= t <= F0,
///                              angle(a, d) <= tolerance,  |axes' b| <= max_other,
///
/// with (A, B) = (J, W) and (a, b) = (f, m) for a force, and the other way round for a moment; s
/// are the torques of `stops`, unilateral constraints that act as additional tendons of one joint
/// each. Other loads of zero are left out. Free ones are eliminated: with N an orthonormal basis of
/// the torques that no b produces (B N = 0), the balance is  N' A' a = N' (R' t + tau_0),  and b is
/// the smallest that balances the rest. Bounded ones are pairs of additional tendons along the
/// axes. What remains is the program of max_tip_force(), whose certificate and prices apply.
/// Moments are scaled to newtons at 10 mm there, so that its thresholds have the same meaning.
///
/// @param statics    one posture; W is needed unless the load is a force and max_other is zero
/// @param direction  wanted direction of the load, any length but zero   3   [1]
/// @throws InputError as max_tip_force(), if W is needed and absent, if max_other is negative or
/// not a number, or if a stop has no such joint or no torque.
/// Source: [ValeroCuevas1998] for the wrench of a fingertip.
[[nodiscard]] MaxTipLoad max_tip_load(const TipStatics& statics, const Eigen::Vector3d& direction,
                                      const TipLoadOptions& options = {});

/// Computes the set of all forces, or all moments, that the tip can exert under the same balance:
/// [N] of FeasibleForceSet then means [N m]. See max_tip_load() and feasible_force_set().
[[nodiscard]] FeasibleForceSet feasible_load_set(const TipStatics& statics,
                                                 const TipLoadOptions& options);

/// Computes the derivative of max_tip_load()'s component by every coordinate, with the prices p of
/// joint torque:
///
///   p' (dtau_0 + dR' t - dA' a - dB' b),  and  - p' (A' (W_k x a) + B' (W_k x b))
///
/// with constant stop torques; the second part if direction and axes turn with the tip. At a
/// degenerate vertex prices are not unique and the derivative is one-sided.
/// @param largest  solved, of `statics`
/// @return (n) [N/rad] or [N m/rad]
[[nodiscard]] Eigen::VectorXd max_tip_load_gradient(const TipStatics& statics,
                                                    const std::vector<StaticsDerivative>& slopes,
                                                    const MaxTipLoad& largest, TipLoad load,
                                                    DirectionFrame frame);

}  // namespace thenar
