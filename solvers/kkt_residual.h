#pragma once

/// First-order optimality of a point, by our own arithmetic.

#include <Eigen/Core>

#include "solvers/nonlinear_program.h"

namespace thenar {

/// Karush, Kuhn and Tucker's conditions at x for prices of rows y and of bounds z: with
///   d = gradient + jacobian' y + z,   y and z > 0 only at upper, < 0 only at lower bounds,
/// a point is stationary where d = 0, and complementary where every price stands at its bound.
/// Prices that push to an infinite bound are taken for zero first, so that they show in d.
///
/// @param rows    prices of the constraints (r);  @param bounds  prices of the bounds of x (n)
[[nodiscard]] KktResidual kkt_residual(const NonlinearProgram& program, const Eigen::VectorXd& x,
                                       Eigen::VectorXd rows, Eigen::VectorXd bounds);

/// The largest of  |gradient| + |jacobian|' |rows| + |bounds|: the scale of rounding in d.
[[nodiscard]] double slope_terms(const NonlinearProgram& program, const Eigen::VectorXd& x,
                                 const Eigen::VectorXd& rows, const Eigen::VectorXd& bounds);

/// Returns the largest violation of bounds and rows by x, each over max(1, |its bound|) [1].
[[nodiscard]] double violation(const NonlinearProgram& program, const Eigen::VectorXd& x);

}  // namespace thenar
