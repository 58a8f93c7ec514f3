#pragma once

/// Linear programs of a few dozen variables, each answer with a certificate of our own.

#include <Eigen/Core>

#include "solvers/status.h"

namespace thenar {

/// maximise objective' x  subject to  row_lower <= A x <= row_upper,  lower <= x <= upper.
/// Bounds may be infinite; an equality has both its bounds alike.
struct LinearProgram {
  Eigen::VectorXd objective;             // (n)
  Eigen::MatrixXd A;                     // (r, n)
  Eigen::VectorXd row_lower, row_upper;  // (r)
  Eigen::VectorXd lower, upper;          // (n)
};

/// How far x is from feasible, and by how much any feasible point can exceed its objective.
struct LinearCertificate {
  double violation;       // largest of a bound or row, over max(1, sum |a_ij x_j|)              [1]
  double dual_violation;  // largest price that no finite bound pays, over max(1, its terms)     [1]
  double gap;             // upper bound of the optimum less objective' x: sum of price x slack
};

struct LinearResult {
  Status status;      // kSolved: x is an optimal vertex; kInfeasible: a Farkas ray shows that no x
                      // obeys all bounds to 1e-9 in the units of the rows; kUnbounded: a feasible
                      // point, and a ray along which the objective grows; kStalled: no certificate
  Eigen::VectorXd x;  // optimal vertex if solved, else zero                    (n)
  double objective;   // there, else NaN
  Eigen::VectorXd duals;          // of the rows: d objective / d row bound if solved, or 0 (r)
  LinearCertificate certificate;  // of x and duals, or of what proves the status
};

/// Solves by the simplex method and believes no solver.
///
/// CLP proposes a basis. Its vertex and duals are computed again from the basis, with refined
/// residuals, and certified by weak duality: x obeys rows and bounds to 1e-12, duals have the sign
/// of the bound that they stand at, and the gap is below 1e-11 of the larger of |objective| and its
/// largest coefficient. If that
/// fails, CLP's dual method, then a dense simplex method of our own are asked. Infeasible and
/// unbounded are certified too: by the least sum of violations, and by a ray.
/// Rows and columns should be of order one. Where rows cannot be met to 1e-12 but to 1e-9, they are
/// relaxed by what is missing: `certificate.violation` states by how much x misses those asked, up
/// to 1e-9, and the gap is that of the relaxed program.
///
/// @throws InputError if shapes disagree, an entry of A or the objective is not finite, or a bound
///         is NaN.
/// Source: [Forrest2005] for CLP, [Bland1977] for the rule that ends our own method.
[[nodiscard]] LinearResult solve(const LinearProgram& program);

}  // namespace thenar
