#pragma once

/// Least squares within bounds, with a linear cost on every unknown.

#include <functional>

#include <Eigen/Core>

namespace thenar {

/// Request for the Jacobian of the residuals.
enum class Sensitivities { kWithout, kWith };

/// Residuals at one point.
struct FitResiduals {
  bool possible = false;  // false: the model has no solution at this point
  Eigen::VectorXd r;      // residuals (m)
  Eigen::MatrixXd J;      // dr/dx; empty unless requested (m, n)
};

/// Problem:  minimise  |r(x)|^2 + price' x   subject to  lower <= x <= upper.
struct BoundedFit {
  Eigen::VectorXd lower, upper, price;  // (n)
  std::function<FitResiduals(const Eigen::VectorXd& x, Sensitivities slopes)> residuals;
};

struct BoundedFitOptions {
  double tolerance = 0.01;           // smallest decrease of the cost that still counts [1]
  double relative_tolerance = 1e-4;  // smallest decrease that still counts, over the cost [1]
  double max_radius = 1;  // half width of the trust region: largest change of an unknown in a step
  int max_steps = 40;     // maximum number of Gauss-Newton steps
};

struct [[nodiscard]] BoundedFitResult {
  bool possible = false;   // the model has a solution at the start
  bool converged = false;  // the decrease that is still possible is below the tolerance
  Eigen::VectorXd x;       // best point found (n)
  FitResiduals residuals;  // residuals at x
  double cost = 0;         // |r|^2 + price' x
  double gap = 0;          // upper bound of the remaining decrease of the last linearised problem
  int steps = 0;           // Gauss-Newton steps taken
};

/// Minimises by Gauss-Newton steps in a box-shaped trust region. Each step minimises a bounded
/// quadratic program by coordinate descent; steps to points without a solution of the model are
/// shortened. Converged means that the linearised problem predicts a decrease below the tolerance,
/// and that its minimum is known to that accuracy by quadratic_gap().
/// @param x0  initial guess, projected onto the bounds (n)
[[nodiscard]] BoundedFitResult bounded_least_squares(const BoundedFit& fit,
                                                     const Eigen::VectorXd& x0,
                                                     const BoundedFitOptions& options = {});

/// Minimises  d' H d + g' d  between bounds; H must be symmetric positive definite (n).
[[nodiscard]] Eigen::VectorXd bounded_quadratic(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                                const Eigen::VectorXd& lower,
                                                const Eigen::VectorXd& upper);

/// Bounds the suboptimality of d in bounded_quadratic() from above: with s = 2 H d + g,
///   sum over i of  max(s_i (d_i - lower_i), s_i (d_i - upper_i)),
/// since a convex function lies above its tangent plane. Infinite if a slope points to an infinite
/// bound. Source: [Frank1956].
[[nodiscard]] double quadratic_gap(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                   const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                                   const Eigen::VectorXd& d);

}  // namespace thenar
