#pragma once

/// A linear program whose answer and duals are known by hand.

#include "base/numbers.h"
#include "solvers/linear_program.h"

namespace thenar::sample {

/// maximise 3x + 2y with x + y <= 4, x + 3y <= 6, 0 <= x <= 3: by hand (3, 1), value 11; the first
/// row is worth 2, the bound of x is worth 1.
inline LinearProgram textbook() {
  LinearProgram program;
  program.objective = Eigen::Vector2d(3, 2);
  program.A = (Eigen::MatrixXd(2, 2) << 1, 1, 1, 3).finished();
  program.row_lower = Eigen::VectorXd::Constant(2, -kInfinity);
  program.row_upper = Eigen::Vector2d(4, 6);
  program.lower = Eigen::Vector2d::Zero();
  program.upper = Eigen::Vector2d(3, kInfinity);
  return program;
}

}  // namespace thenar::sample
