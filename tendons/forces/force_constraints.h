#pragma once

/// Nonlinear constraints on a tip force and its tensions.

#include <functional>

#include <Eigen/Core>

namespace thenar {

/// Value of a constraint g(f, t) <= 0, one inequality per row, and its gradients.
struct ConstraintValue {
  Eigen::VectorXd g;       // (k)
  Eigen::MatrixX3d dg_df;  // (k, 3) [unit of g / N]
  Eigen::MatrixXd dg_dt;   // (k, m) [unit of g / N]
};

/// Smooth constraint on the force f of the tip on the world [N] (3) and the tensions t [N] (m).
using ForceConstraint =
    std::function<ConstraintValue(const Eigen::Vector3d& f, const Eigen::VectorXd& t)>;

/// Builds the effort constraint  sum (t_i / F0_i)^p - max_effort <= 0,  over muscles whose F0 is
/// not zero.
///
/// @param max_tension  F0, finite, >= 0   m   [N]
/// @param p            >= 1               [1]
/// @param max_effort   > 0                [1]
/// @throws InputError if an argument is out of range.
/// Source: [Crowninshield1981] for effort as a sum of powers of muscle stress.
[[nodiscard]] ForceConstraint effort_constraint(const Eigen::VectorXd& max_tension, double p,
                                                double max_effort);

/// Builds the Coulomb friction constraint of the tip on a surface,  |f_t|^2 - mu^2 f_n^2 <= 0  and
/// -f_n <= 0, in units of 1 N^2 and 1 N, with f_n = n' f and f_t = f - n f_n. It is smooth also at
/// zero force.
///
/// @param n   direction in which the tip presses, into the surface; any length   3
/// @param mu  coefficient of friction, >= 0   [1]
/// @throws InputError if n is zero or not finite, or mu is negative or not finite.
[[nodiscard]] ForceConstraint friction_constraint(const Eigen::Vector3d& n, double mu);

/// Builds a constraint that keeps a load linear in force and tensions within an ellipsoid:  |A f +
/// B t + b|^2 - 1 <= 0.
///
/// A joint reaction force of at most r newton has A = 1 / r, B = the directions in which tendons
/// press the joint, / r. A torque ellipsoid has A = S J', with S the inverse of its half axes.
///
/// @param A  k x 3  [1/N];  @param B  k x m  [1/N];  @param b  k  [1]
/// @throws InputError if shapes disagree or an entry is not finite.
[[nodiscard]] ForceConstraint load_constraint(const Eigen::MatrixX3d& A, const Eigen::MatrixXd& B,
                                              const Eigen::VectorXd& b);

}  // namespace thenar
