#pragma once

/// The normal density that touches another one.

#include "sampling/target.h"

namespace thenar {

/// Inverse of  -d2 log p / dx2  at x, by central differences of the gradient (n, n). Directions
/// in which the density bends the wrong way, or hardly, count as bent by a twentieth of a standard
/// normal; the identity where gradients are not finite: it is a guess to start from.
[[nodiscard]] Eigen::MatrixXd laplace_covariance(const Target& target, const Eigen::VectorXd& x);

}  // namespace thenar
