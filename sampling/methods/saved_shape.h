#pragma once

/// Reading of matrices of a required shape from saved states.

#include <Eigen/Core>

#include "base/error.h"
#include "sampling/methods/state_bytes.h"

namespace thenar::internal {

/// Reads the next matrix of a saved state. @param what  name of the matrix for messages
/// @throws InputError if it has another shape.
[[nodiscard]] inline Eigen::MatrixXd saved_matrix(StateReader& from, const char* what,
                                                  Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd found = from.matrix();
  require(found.rows() == rows && found.cols() == columns,
          "saved state, {}: wanted {} x {} numbers, got {} x {}", what, rows, columns, found.rows(),
          found.cols());
  return found;
}

/// Reads the next vector of a saved state. Arguments as for saved_matrix().
[[nodiscard]] inline Eigen::VectorXd saved_vector(StateReader& from, const char* what,
                                                  Eigen::Index size) {
  return saved_matrix(from, what, size, 1);
}

}  // namespace thenar::internal
