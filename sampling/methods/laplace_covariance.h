#pragma once

/// The normal density that touches another one.

#include "sampling/methods/target.h"

namespace thenar {

/// Inverse of  -d2 log p / dx2  at x, by central differences of the gradient (n, n). It is a guess
/// to start from: where the density bends the wrong way, it counts as bent as much the right way;
/// at least by a twentieth of a standard normal. The identity where gradients are not finite.
[[nodiscard]] Eigen::MatrixXd laplace_covariance(const Target& target, const Eigen::VectorXd& x);

}  // namespace thenar
