#pragma once

/// Linear programs of a few dozen variables.

#include <Eigen/Core>

namespace thenar {

/// maximise objective' x  subject to  row_lower <= A x <= row_upper,  lower <= x <= upper.
/// Bounds may be infinite; an equality has both its bounds alike.
struct LinearProgram {
  Eigen::VectorXd objective;             // (n)
  Eigen::MatrixXd A;                     // (r, n)
  Eigen::VectorXd row_lower, row_upper;  // (r)
  Eigen::VectorXd lower, upper;          // (n)
};

enum class LinearStatus {
  kSolved,      // x is an optimal vertex
  kInfeasible,  // no x obeys all bounds, within 1e-9 in the units of the rows
  kUnbounded,   // the objective grows without limit
  kStalled      // the simplex method gave up: numerical trouble or cycling
};

struct LinearResult {
  LinearStatus status;  // read this first
  Eigen::VectorXd x;    // optimal vertex if solved, else zero (n)
  double objective;     // there, else NaN
};

/// Solves by the simplex method of CLP, whose answer is a vertex, exact to rounding.
///
/// Rows and columns should be of order one. Rows are met to 1e-12; if that fails, to 1e-9.
///
/// @throws InputError if shapes disagree, an entry of A or the objective is not finite, or a bound
///         is NaN.
/// Source: [Forrest2005].
[[nodiscard]] LinearResult solve(const LinearProgram& program);

}  // namespace thenar
