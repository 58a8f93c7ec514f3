#pragma once

/// Parametrisation of balanced forces and tensions for methods that need an interior.

#include <Eigen/Core>

#include "solvers/linear_program.h"
#include "solvers/nonlinear_program.h"

namespace thenar::internal {

/// Parametrisation  z = z0 + Z y  of { z : E z = e, lower <= z <= upper }, bounds permitting.
///
/// Variables that the constraints fix at one value (e.g. an unopposed tension, which stays zero)
/// are found by linear programs and eliminated, so that z0 is strictly inside all other bounds and
/// every y satisfies the equalities exactly.
struct RelativeInterior {
  Status status = Status::kStalled;  // kInfeasible: the set is empty
  Eigen::VectorXd z0;                // point in the relative interior                         (n)
  Eigen::MatrixXd Z;  // orthonormal columns; rows of fixed variables are exactly 0    (n, k)
  Eigen::VectorXd lower, upper;  // bounds of z; infinite at fixed variables (n)
};

/// Finds the relative interior. Uses only E (`A` with equal row bounds) and the bounds of
/// `program`.
[[nodiscard]] RelativeInterior relative_interior(LinearProgram program);

/// Returns a program over y whose constraints are the finite bounds of z. The caller adds the
/// objective and any further constraints.
[[nodiscard]] NonlinearProgram program_over_interior(const RelativeInterior& interior);

}  // namespace thenar::internal
