#pragma once

/// Linear programs of a few dozen variables; each answer has a certificate.

#include <Eigen/Core>

#include "solvers/status.h"

namespace thenar {

/// Problem:  maximise objective' x  subject to  row_lower <= A x <= row_upper,  lower <= x <=
/// upper. Bounds may be infinite; the two bounds of an equality are equal.
struct LinearProgram {
  Eigen::VectorXd objective;             // (n)
  Eigen::MatrixXd A;                     // (r, n)
  Eigen::VectorXd row_lower, row_upper;  // (r)
  Eigen::VectorXd lower, upper;          // (n)
};

/// Certificate of x: its infeasibility, and an upper bound of how much any feasible point can
/// exceed its objective. Duals of the bounds of x are  d = objective - A' duals.
struct LinearCertificate {
  double violation = 0;  // largest violation of a bound or row, over max(1, sum |a_ij x_j|) [1]
  double dual_violation = 0;  // largest dual that pushes to an infinite bound, over max(1, sum of
                              // the absolute values of its terms) [1]
  double gap = 0;  // upper bound of the optimum minus objective' x: sum of |dual| x slack, in units
                   // of the objective
};

/// Answer of a linear program, with its certificate. Contents of the fields for each status:
///
/// | status | x | duals | certificate | ray |
/// |---|---|---|---|---|
/// | kSolved | optimal vertex | of the rows | of x and duals | empty |
/// | kInfeasible | zero | zero | of the least sum of violations | y (r), see below |
/// | kUnbounded | feasible to 1e-9 | zero | of the greatest growth | v (n), see below |
/// | kStalled | zero | zero | NaN | empty |
///
/// Infeasible: no x between its bounds satisfies all rows to a sum of violations of 1e-9. With
/// |y_i| <= 1,  min over these x of  y' A x  exceeds  sum_i max(y_i row_lower_i, y_i row_upper_i)
/// (Farkas); entries of y whose bound is infinite are below 1e-11 and count as zero. If a lower
/// bound exceeds its upper bound, no proof is needed: the ray is empty and the certificate NaN.
/// Unbounded: x + s v is feasible for all s >= 0, its objective grows by objective' v > 0, and
/// |v_j| <= 1.
struct LinearResult {
  Status status = Status::kStalled;
  Eigen::VectorXd x;              // (n)
  double objective = 0;           // objective' x if solved, else NaN
  Eigen::VectorXd duals;          // d objective / d row bound (r)
  LinearCertificate certificate;  // certificate of x and duals; NaN: none
  Eigen::VectorXd ray = {};       // proof of kInfeasible or kUnbounded
};

/// Solves by the simplex method, and certifies the answer independently of the solver.
///
/// CLP proposes a basis. Its vertex and duals are recomputed from the basis with iterative
/// refinement, and certified by weak duality: x satisfies rows and bounds to 1e-12, each dual has
/// the sign of the bound at which its row or variable lies, and the gap is below 1e-11 of the
/// larger of |objective| and its largest coefficient. If that fails, CLP's dual method is tried,
/// then a dense simplex method. Infeasibility and unboundedness are certified too: by the minimum
/// sum of violations, and by a ray. Rows and columns should be of order one. Rows that can be
/// satisfied to 1e-9 but not to 1e-12 are relaxed by the difference: then `certificate.violation`
/// gives the violation of the original rows by x, up to 1e-9, and the gap is that of the relaxed
/// program.
///
/// @throws InputError if shapes disagree, an entry of A or the objective is not finite, or a bound
///         is NaN.
/// Source: [Forrest2005] for CLP, [Bland1977] for the rule that prevents cycling.
[[nodiscard]] LinearResult solve(const LinearProgram& program);

}  // namespace thenar
