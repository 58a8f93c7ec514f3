#pragma once

/// Certificate of optimality of a vertex of a linear program, by our own arithmetic.

#include <vector>

#include <Eigen/Core>

#include "solvers/linear_program.h"

namespace thenar::internal {

/// Basis of  A x - z = 0,  where z are the activities of the rows: r variables are basic, all
/// others stand at a bound.
struct SimplexBasis {
  std::vector<Eigen::Index> basic;  // r of 0 .. n + r - 1: x first, then z
  Eigen::VectorXd at;               // values of the others; basic entries are not looked at (n + r)
};

/// A point and the duals of the rows.
struct PrimalDualPoint {
  Eigen::VectorXd x;      // (n)
  Eigen::VectorXd duals;  // (r)
};

/// Solves  B v = -N at  and  B' duals = c_B  with residuals in long double, x then put between its
/// bounds. Entries are not finite if B is singular.
[[nodiscard]] PrimalDualPoint vertex_of(const LinearProgram& program, const SimplexBasis& basis);

/// Weak duality. For any duals y, with d = objective - A' y and every feasible x*,
///
///   objective' (x* - x) <= sum |d_j| (distance of x_j to the bound that d_j pushes to)
///                        + sum |y_i| (distance of a_i' x to the bound that y_i pushes to),
///
/// a sum of products that are all zero at an optimal vertex, so that nothing cancels. A price whose
/// bound is infinite is `dual_violation`; it adds |d_j x_j| to the gap.
[[nodiscard]] LinearCertificate certify(const LinearProgram& program, const PrimalDualPoint& point);

/// Violation 1e-12, dual_violation 1e-11, gap 1e-11 of max(1, |objective|); false if anything is
/// NaN.
[[nodiscard]] bool holds(const LinearCertificate& certificate, double objective);

}  // namespace thenar::internal
