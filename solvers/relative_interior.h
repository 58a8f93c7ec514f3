#pragma once

/// Balanced forces and tensions as a smooth parametrisation, for methods that need an interior.

#include <Eigen/Core>

#include "solvers/linear_program.h"
#include "solvers/nonlinear_program.h"

namespace thenar::internal {

/// The points of { z : E z = e, lower <= z <= upper } are  z = z0 + Z y,  bounds permitting.
///
/// Variables that the equalities pin to one value (a tension that nobody can oppose stays zero) are
/// found by linear programs and taken out, so z0 is strictly inside all other bounds and every y
/// balances exactly.
struct RelativeInterior {
  Status status;                 // kInfeasible: there is no such z
  Eigen::VectorXd z0;            // relative interior point                              (n)
  Eigen::MatrixXd Z;             // orthonormal; rows of pinned variables are exact 0    (n, k)
  Eigen::VectorXd lower, upper;  // of z; infinite at pinned variables                   (n)
};

/// Finds the relative interior. It uses only E, its row bounds (alike) and the bounds of `program`.
[[nodiscard]] RelativeInterior relative_interior(LinearProgram program);

/// A program over y whose constraints are the finite bounds of z. The objective, and whatever else
/// limits z, is the caller's to add.
[[nodiscard]] NonlinearProgram program_over_interior(const RelativeInterior& interior);

}  // namespace thenar::internal
