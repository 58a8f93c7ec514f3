#pragma once

/// Certificate of optimality of a vertex of a linear program, independent of the solver.

#include <vector>

#include <Eigen/Core>

#include "solvers/linear_program.h"

namespace thenar::internal {

/// Basis of  A x - z = 0,  where z are the row activities: r variables are basic, all others are at
/// a bound.
struct SimplexBasis {
  std::vector<Eigen::Index> basic;  // r indices in 0 .. n + r - 1: x first, then z
  Eigen::VectorXd values;  // values of the nonbasic variables; basic entries are ignored (n + r)
};

/// Point and duals of the rows.
struct PrimalDualPoint {
  Eigen::VectorXd x;      // (n)
  Eigen::VectorXd duals;  // (r)
};

/// Solves  B v = -N values  and  B' duals = c_B  with residuals in long double, then projects x
/// onto its bounds. Entries are not finite if B is singular.
[[nodiscard]] PrimalDualPoint vertex_of(const LinearProgram& program, const SimplexBasis& basis);

/// Certifies a point by weak duality. For any duals y, with d = objective - A' y and every feasible
/// x*,
///
///   objective' (x* - x) <= sum |d_j| (distance of x_j to the bound that d_j pushes to)
///                        + sum |y_i| (distance of a_i' x to the bound that y_i pushes to),
///
/// a sum of products that all vanish at an optimal vertex, so that there is no cancellation. A dual
/// that pushes to an infinite bound counts as `dual_violation`, and adds |d_j x_j| to the gap.
[[nodiscard]] LinearCertificate certify(const LinearProgram& program, const PrimalDualPoint& point);

/// Returns whether violation <= 1e-12, dual_violation <= 1e-11 and gap <= 1e-11 max(1,
/// |objective|); false if any is NaN.
[[nodiscard]] bool is_certified(const LinearCertificate& certificate, double objective);

}  // namespace thenar::internal
