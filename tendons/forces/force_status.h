#pragma once

#include "solvers/linear_program.h"
#include "solvers/nonlinear_program.h"

namespace thenar {

/// How a question about feasible forces ended.
enum class ForceStatus {
  kSolved,      // the rest of the result is the answer
  kInfeasible,  // no tensions balance any force asked for; forces and tensions are zero
  kUnbounded,   // F0 is infinite where it matters, or the skeleton alone carries the load
  kStalled      // the numerical method gave up; forces and tensions are not to be used
};

namespace internal {

[[nodiscard]] inline ForceStatus force_status(LinearStatus status) {
  switch (status) {
    case LinearStatus::kSolved:
      return ForceStatus::kSolved;
    case LinearStatus::kInfeasible:
      return ForceStatus::kInfeasible;
    case LinearStatus::kUnbounded:
      return ForceStatus::kUnbounded;
    default:
      return ForceStatus::kStalled;
  }
}

[[nodiscard]] inline ForceStatus force_status(NonlinearStatus status) {
  switch (status) {
    case NonlinearStatus::kSolved:
    case NonlinearStatus::kAcceptable:
      return ForceStatus::kSolved;
    case NonlinearStatus::kInfeasible:
      return ForceStatus::kInfeasible;
    case NonlinearStatus::kUnbounded:
      return ForceStatus::kUnbounded;
    default:
      return ForceStatus::kStalled;
  }
}

}  // namespace internal
}  // namespace thenar
