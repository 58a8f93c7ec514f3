#pragma once

/// A simplex method of our own for small dense programs: asked where CLP's answer fails.

#include "solvers/linear_certificate.h"
#include "solvers/status.h"

namespace thenar::internal {

struct SimplexVertex {
  Status end;          // what the method believes; the caller certifies it
  SimplexBasis basis;  // the last one
};

/// Primal simplex with bounds on all variables, from the basis of row activities.
///
/// Every step factors the basis anew, so that no error is carried along. While basic variables are
/// outside their bounds, the sum of what they miss is lessened first. The steepest price enters;
/// after ten steps a variable the least index does [Bland1977], which cannot cycle.
///
/// @param program  checked by the caller; lower bounds not above upper ones
[[nodiscard]] SimplexVertex dense_simplex(const LinearProgram& program);

}  // namespace thenar::internal
