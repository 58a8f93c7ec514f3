#pragma once

/// Reactions of joint limits and locks, which need no actuator.

#include "hand/hand.h"

namespace thenar {

/// Distance from a limit within which a coordinate rests on it [rad] or [m]
inline constexpr double kLimitTolerance = 1e-4;

/// Returns the actuation of a hand at a posture, with the joint limits on which coordinates rest:
/// each is a reaction >= 0, towards the inside of the range. For human joints it represents the
/// ligaments and bones that end their motion.
/// @param q  (coordinates) [rad], of sliding joints [m]
[[nodiscard]] Actuation actuation_with_joint_limits(const Hand& hand, const Eigen::VectorXd& q);

/// Appends a reaction.
/// @param torque      joint torques of the unit reaction (coordinates)
/// @param lower, upper  bounds of the reaction; infinite: none [N m]
void add_reaction(Reactions& reactions, const Eigen::VectorXd& torque, double lower, double upper);

/// Returns the rows of R of some coordinates. A reaction that shares torque between coordinates (a
/// clutch) counts only if the innermost of them is listed; otherwise its column is zero. Columns of
/// joint limits of non-backdrivable coordinates are also zero: the drive supports the same torque.
/// @param coordinates  ascending
[[nodiscard]] Eigen::MatrixXd reactions_on(const Reactions& reactions,
                                           const std::vector<int>& coordinates);

/// Returns whether reactions of this coordinate alone can balance a torque of any magnitude with
/// the sign of `direction`.
[[nodiscard]] bool resists_torque(const Reactions& reactions, Eigen::Index coordinate,
                                  double direction);

/// Returns whether reactions can balance any torque of both signs: a lock, or limits without a
/// range between them.
[[nodiscard]] bool is_locked(const Reactions& reactions, Eigen::Index coordinate);

}  // namespace thenar
