#pragma once

/// Products of a matrix with one vector, compiled for several processors.

#include <Eigen/Core>

namespace thenar::internal {

/// Shape of a square matrix, by the entries that may differ from zero.
enum class Shape { kFull, kLower };

// The processor is asked at run time. All versions give the same bits: the order of no sum depends
// on the processor, and no multiplication is fused (-ffp-contract=off).

/// x += F y  (n, n), (n), (n)
void add_product(const Eigen::MatrixXd& F, Shape shape, const Eigen::VectorXd& y,
                 Eigen::VectorXd& x);

/// F' g, into `out`  (n, n), (n), (n)
void transposed_product(const Eigen::MatrixXd& F, Shape shape, const Eigen::VectorXd& g,
                        Eigen::VectorXd& out);

}  // namespace thenar::internal
