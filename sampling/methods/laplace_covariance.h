#pragma once

/// Laplace approximation of a density: the normal density of the same curvature.

#include "sampling/methods/target.h"

namespace thenar {

/// Returns the inverse of  -d2 log p / dx2  at x, by central differences of the gradient (n, n), as
/// a first guess for samplers: eigenvalues of the curvature count by their absolute value and are
/// at least 0.05, a twentieth of a standard normal's. Returns the identity where gradients are not
/// finite.
/// @param x  in units of prior sds [1] (n)
[[nodiscard]] Eigen::MatrixXd laplace_covariance(const Target& target, const Eigen::VectorXd& x);

}  // namespace thenar
