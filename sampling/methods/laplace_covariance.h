#pragma once

/// Laplace approximation of a density: the normal density of equal curvature.

#include "sampling/methods/target.h"

namespace thenar {

/// Returns the inverse of  -d2 log p / dx2  at x, by central differences of the gradient (n, n), as
/// an initial covariance for samplers. Eigenvalues of the curvature are replaced by their absolute
/// values and are at least 0.05, a twentieth of a standard normal's. Returns the identity if
/// gradients are not finite.
/// @param x  point in units of prior sds [1] (n)
[[nodiscard]] Eigen::MatrixXd laplace_covariance(const Target& target, const Eigen::VectorXd& x);

}  // namespace thenar
