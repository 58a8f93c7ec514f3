#pragma once

/// First-order optimality of a point, independent of the solver.

#include <Eigen/Core>

#include "solvers/nonlinear_program.h"

namespace thenar {

/// Computes the residuals of the Karush-Kuhn-Tucker conditions at x for multipliers of rows y and
/// of bounds z: with
///   d = gradient + jacobian' y + z,   y and z > 0 only at upper, < 0 only at lower bounds,
/// a point is stationary where d = 0, and complementary where every nonzero multiplier belongs to
/// an active bound. Multipliers of infinite bounds are set to zero first, so that they show up in
/// d.
///
/// @param rows    multipliers of the constraints (r)
/// @param bounds  multipliers of the bounds of x (n)
[[nodiscard]] KktResidual kkt_residual(const NonlinearProgram& program, const Eigen::VectorXd& x,
                                       Eigen::VectorXd rows, Eigen::VectorXd bounds);

/// Returns the maximum of  |gradient| + |jacobian|' |rows| + |bounds|:  the scale of rounding
/// errors in d.
[[nodiscard]] double gradient_scale(const NonlinearProgram& program, const Eigen::VectorXd& x,
                                    const Eigen::VectorXd& rows, const Eigen::VectorXd& bounds);

/// Returns the largest violation of bounds and rows by x, each over max(1, |its bound|) [1].
[[nodiscard]] double violation(const NonlinearProgram& program, const Eigen::VectorXd& x);

}  // namespace thenar
