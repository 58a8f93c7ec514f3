#pragma once

/// Static balance of a pinned tip as linear equations in force and activation.

#include <Eigen/Core>

#include "hand/tip_manipulability.h"
#include "solvers/linear_program.h"
#include "tendons/tip_statics.h"

namespace thenar::internal {

/// Components of unit vectors below this count as rounding errors [1].
inline constexpr double kUnitRounding = 1e-14;

/// Throws InputError unless shapes agree, entries are finite and no F0 is negative or NaN.
void require_statics(const TipStatics& statics);

/// Throws InputError unless t has `tendons` entries, each finite and >= 0.
void require_tension(Eigen::Index tendons, const Eigen::Ref<const Eigen::VectorXd>& t);

/// Balance of a pinned tip in scaled, dimensionless torque rows:
///
///   force_part phi + tension_part a = constant,   f = force_unit U phi,   t_i = unit_i a_i,
///   0 <= a_i <= upper_i
///
/// with J = U S V' and singular values below kRankTolerance set to exactly zero, so that forces
/// carried by the skeleton alone have columns of exact zeros and not of rounding.
struct TipBalance {
  Eigen::Matrix3d U;             // columns: left singular vectors of J (3, 3)
  int rank = 0;                  // rank of J: columns of force_part from here on are 0 [1]
  double force_unit = 0;         // force of the size that tendons produce [N]
  Eigen::VectorXd row_scale;     // factor of each torque row (n) [1/(N m)]
  Eigen::MatrixXd force_part;    // force_unit V S, rows scaled (n, 3)
  Eigen::MatrixXd tension_part;  // -R' diag(unit), rows scaled (n, m)
  Eigen::VectorXd constant;      // tau_0, rows scaled (n)
  Eigen::VectorXd unit;          // tension of a = 1: F0, or 1 N if F0 is infinite or 0 (m) [N]
  Eigen::VectorXd upper;         // upper bound of a: 1, infinite, or 0 (m)
};

/// Builds the scaled balance.
[[nodiscard]] TipBalance tip_balance(const TipStatics& statics);

/// Builds the program of the balance under amounts of some loads, of either sign, and activations
/// within their bounds:  loads x + tension_part a = constant.
/// @param loads  torque rows of each load, scaled as `force_part` (n, k)
[[nodiscard]] LinearProgram balance_program(const TipBalance& balance,
                                            const Eigen::MatrixXd& loads);

/// Computes the tensions t of the scaled activations `a`, clamped to their bounds.  a (m) [1],
/// result (m) [N]
[[nodiscard]] Eigen::VectorXd tension(const TipBalance& balance, const Eigen::VectorXd& a);

/// Computes t / F0; zero where F0 is zero or infinite.  (m)
[[nodiscard]] Eigen::VectorXd activation(const TipStatics& statics, const Eigen::VectorXd& t);

/// Computes the largest unbalanced joint torque, max |J' f - R' t - tau_0|  [N m].
[[nodiscard]] double imbalance(const TipStatics& statics, const Eigen::Vector3d& force,
                               const Eigen::VectorXd& tension);

/// Returns `unit_vectors` (columns) with components below kUnitRounding set to zero.  (3, k)
[[nodiscard]] Eigen::Matrix3Xd without_rounding(const Eigen::Matrix3Xd& unit_vectors);

/// Normalises `direction`; throws InputError if it is zero or not finite.
[[nodiscard]] Eigen::Vector3d unit_direction(const Eigen::Vector3d& direction);

}  // namespace thenar::internal
