#pragma once

/// Simplex method for small dense programs: the fallback if CLP's answers fail their certificate.

#include "solvers/linear_certificate.h"
#include "solvers/status.h"

namespace thenar::internal {

struct SimplexVertex {
  Status claim = Status::kStalled;  // claim of the method, to be certified by the caller
  SimplexBasis basis;               // final basis
};

/// Runs the primal simplex method with bounds on all variables, starting from the basis of row
/// activities.
///
/// Every step factorises the basis from scratch, so that errors do not accumulate. While basic
/// variables violate their bounds, phase 1 reduces the sum of the violations. The entering variable
/// has the largest reduced cost; after ten steps per variable, Bland's least-index rule prevents
/// cycling [Bland1977].
///
/// @param program  valid program, lower bounds not above upper ones; not checked
[[nodiscard]] SimplexVertex dense_simplex(const LinearProgram& program);

}  // namespace thenar::internal
