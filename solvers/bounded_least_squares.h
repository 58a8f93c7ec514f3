#pragma once

/// Least squares within bounds, with a linear price on every unknown.

#include <functional>

#include <Eigen/Core>

namespace thenar {

enum class Sensitivities { kWithout, kWith };

/// Residuals at one point.
struct FitResiduals {
  bool possible = false;  // false: the model has no answer there
  Eigen::VectorXd r;      // (m)
  Eigen::MatrixXd J;      // dr/dx (m, n); if asked for
};

/// minimise  |r(x)|^2 + price' x   subject to  lower <= x <= upper.
struct BoundedFit {
  Eigen::VectorXd lower, upper, price;  // (n)
  std::function<FitResiduals(const Eigen::VectorXd& x, Sensitivities slopes)> residuals;
};

struct BoundedFitOptions {
  double tolerance = 0.01;  // fall of the cost that still counts [1]
  double relative = 1e-4;   // the same, as a part of the cost [1]
  double radius = 1;        // farthest move of an unknown in one step
  int max_steps = 40;
};

struct [[nodiscard]] BoundedFitResult {
  bool possible = false;   // the start had an answer
  bool converged = false;  // to the tolerance
  Eigen::VectorXd x;
  FitResiduals at;  // there
  double cost = 0;  // |r|^2 + price' x
  double gap = 0;   // of the last linearised problem: what its minimum may still be lower
  int steps = 0;
};

/// Gauss-Newton steps in a box-shaped trust region, each the minimum of a bounded quadratic program
/// found by coordinate descent. Steps to where the model has no answer are shortened. Converged
/// means that the linearised problem promises no more than the tolerance, and that its own minimum
/// is found to that by quadratic_gap().
/// @param x0  is moved between the bounds first (n)
[[nodiscard]] BoundedFitResult bounded_least_squares(const BoundedFit& fit,
                                                     const Eigen::VectorXd& x0,
                                                     const BoundedFitOptions& options = {});

/// minimise  d' H d + g' d  between bounds; H symmetric positive definite.
[[nodiscard]] Eigen::VectorXd bounded_quadratic(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                                const Eigen::VectorXd& lower,
                                                const Eigen::VectorXd& upper);

/// Upper bound of how much lower the minimum of bounded_quadratic() is than d: with s = 2 H d + g,
///   sum over i of  max(s_i (d_i - lower_i), s_i (d_i - upper_i)),
/// as the tangent plane lies below a convex function. Infinite where a slope leads to no bound.
/// Source: [Frank1956].
[[nodiscard]] double quadratic_gap(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                   const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                                   const Eigen::VectorXd& d);

}  // namespace thenar
