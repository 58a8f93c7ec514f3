#pragma once

/// Reaction torques of joint limits and locks, which need no actuator.

#include "hand/hand.h"

namespace thenar {

/// A coordinate nearer to its limit than this rests on it [rad] or [m].
inline constexpr double kAtLimit = 1e-4;

/// Actuation of a hand at a posture, with the joint limits on which coordinates rest: each is a
/// reaction from zero upwards, towards the inside of the range. For human joints it stands for the
/// ligaments and bones that end their motion.
/// @param q  (coordinates) [rad], of sliding joints [m]
[[nodiscard]] Actuation actuation_with_joint_limits(const Hand& hand, const Eigen::VectorXd& q);

/// Appends a reaction.
/// @param torque      joint torques of the unit reaction (coordinates)
/// @param lower, upper  limits of the reaction; infinite: none [N m]
void add_reaction(Reactions& reactions, const Eigen::VectorXd& torque, double lower, double upper);

/// Rows of R of some coordinates. A reaction that shares torque between coordinates (a clutch)
/// counts only if the innermost of them is among these; otherwise its column is zero. Columns of
/// joint limits of non-backdrivable coordinates are zero, too: the drive supports the same torque.
/// @param coordinates  ascending
[[nodiscard]] Eigen::MatrixXd reactions_on(const Reactions& reactions,
                                           const std::vector<int>& coordinates);

/// Returns whether reactions of this coordinate alone balance any torque of the sign of
/// `direction`.
[[nodiscard]] bool bears_torque(const Reactions& reactions, Eigen::Index coordinate,
                                double direction);

/// Returns whether reactions balance any torque of both signs: a lock, or limits that leave no
/// range.
[[nodiscard]] bool is_locked(const Reactions& reactions, Eigen::Index coordinate);

}  // namespace thenar
