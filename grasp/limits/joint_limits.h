#pragma once

/// Torques that come without effort: of joints at the ends of their ranges, and of locks.

#include "hand/hand.h"

namespace thenar {

/// How near to its limit a coordinate rests on a stop [rad] or [m].
inline constexpr double kAtLimit = 1e-4;

/// What a hand can do at a posture, with the stops of every coordinate at a limit: a reaction from
/// zero upwards, towards the inside of its range. Of human joints it stands for the ligaments and
/// bones that end their motion.
/// @param q  (coordinates) [rad], of sliding joints [m]
[[nodiscard]] Actuation actuation_with_joint_limits(const Hand& hand, const Eigen::VectorXd& q);

/// Appends a reaction. @param torque  of it at 1 (coordinates)
void add_reaction(Reactions& reactions, const Eigen::VectorXd& torque, double least, double most);

/// The rows of R of some coordinates. A reaction that shares torque between coordinates (a clutch)
/// does so only if the innermost of them is among these: else its columns are zero. So are those of
/// stops of held coordinates: worms bear what they would.
/// @param coordinates  ascending
[[nodiscard]] Eigen::MatrixXd reactions_on(const Reactions& reactions,
                                           const std::vector<int>& coordinates);

/// Whether a reaction of this coordinate alone balances whatever torque comes, of the sign of
/// `way`.
[[nodiscard]] bool bears_torque(const Reactions& reactions, Eigen::Index coordinate, double way);

/// Whether the same holds both ways: a lock, or stops that leave no range.
[[nodiscard]] bool is_locked(const Reactions& reactions, Eigen::Index coordinate);

}  // namespace thenar
