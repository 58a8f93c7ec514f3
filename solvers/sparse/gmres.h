#pragma once

/// Iterative solution of systems with a good preconditioner.

#include <functional>

#include <Eigen/Core>

namespace thenar {

/// Solves  A x = b  for a matrix near the identity, of which only products are available:
/// minimises |b - A x| over the Krylov space of A and b, without restarts.
/// @param apply           function that multiplies a vector by A (n)
/// @param b               right-hand side (n)
/// @param tolerance       largest |b - A x| over |b| at which iterations stop [1]
/// @param max_iterations  maximum number of products with A; the best solution so far is returned
/// Source: [SaadSchultz1986].
[[nodiscard]] Eigen::VectorXd gmres(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply, const Eigen::VectorXd& b,
    double tolerance, int max_iterations);

}  // namespace thenar
