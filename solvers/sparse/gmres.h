#pragma once

/// Systems that a good guess of their inverse solves in a few steps.

#include <functional>

#include <Eigen/Core>

namespace thenar {

/// Solves  A x = b  for a matrix near the identity, of which only products are known: minimises
/// |b - A x| over ever more products of b with A, without restarts.
/// @param apply  A times a vector of n
/// @param b      (n)
/// @param tolerance       of |b - A x| over |b| [1]
/// @param max_iterations  products with A; the best answer of so many is returned
/// Source: [SaadSchultz1986].
[[nodiscard]] Eigen::VectorXd gmres(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply, const Eigen::VectorXd& b,
    double tolerance, int max_iterations);

}  // namespace thenar
