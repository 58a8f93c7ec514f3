#pragma once

/// Products of a matrix and a vector, compiled for several instruction sets.

#include <Eigen/Core>

namespace thenar::internal {

/// Structure of a square matrix: which entries may be nonzero.
enum class Shape { kFull, kLower };

// The instruction set is chosen at run time. All versions give the same bits: no order of summation
// depends on it, and no multiplication is fused (-ffp-contract=off).

/// Computes x += F y  (n, n), (n), (n).
void add_product(const Eigen::MatrixXd& F, Shape shape, const Eigen::VectorXd& y,
                 Eigen::VectorXd& x);

/// Computes out = F' g  (n, n), (n), (n).
void transposed_product(const Eigen::MatrixXd& F, Shape shape, const Eigen::VectorXd& g,
                        Eigen::VectorXd& out);

}  // namespace thenar::internal
