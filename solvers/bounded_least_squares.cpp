#include "solvers/bounded_least_squares.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thenar {
namespace {

constexpr double kMinRadius = 1e-9;  // trust radius below which the fit ends
constexpr int kMaxSweeps = 400;      // maximum number of sweeps of coordinate descent
// Relative move in a sweep below which coordinate descent has converged [1]
constexpr double kMoveTolerance = 1e-9;

// Gap of a linearised problem that further sweeps do not reduce
constexpr double kMinGap = 1e-6;

/// Returns the minimiser of the linearised problem in the trust region, and stores its gap in
/// `current`.
Eigen::VectorXd trust_region_step(const BoundedFit& fit, BoundedFitResult& current, double radius) {
  // Gauss-Newton Hessian, slightly regularised.
  Eigen::MatrixXd H = current.residuals.J.transpose() * current.residuals.J;
  H.diagonal().array() += 1e-9 * H.diagonal().maxCoeff() + 1e-12;
  const Eigen::VectorXd g = 2 * current.residuals.J.transpose() * current.residuals.r + fit.price;
  // Intersect bounds and trust region.
  const Eigen::VectorXd lower = (fit.lower - current.x).cwiseMax(-radius);
  const Eigen::VectorXd upper = (fit.upper - current.x).cwiseMin(radius);
  Eigen::VectorXd d = bounded_quadratic(H, g, lower, upper);
  current.gap = quadratic_gap(H, g, lower, upper, d);
  return d;
}

/// Returns the change of the cost that the linearised problem predicts for a step.
double predicted_change(const BoundedFit& fit, const BoundedFitResult& current,
                        const Eigen::VectorXd& d) {
  return (current.residuals.r + current.residuals.J * d).squaredNorm() -
         current.residuals.r.squaredNorm() + fit.price.dot(d);
}

}  // namespace

Eigen::VectorXd bounded_quadratic(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                  const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  // Coordinate descent from the feasible point nearest to zero.
  Eigen::VectorXd d = Eigen::VectorXd::Zero(g.size()).cwiseMax(lower).cwiseMin(upper);
  Eigen::VectorXd slope = 2 * H * d + g;
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    double largest_move = 0;
    for (Eigen::Index i = 0; i < g.size(); ++i) {
      const double unbounded = d(i) - slope(i) / (2 * H(i, i));
      const double move = std::clamp(unbounded, lower(i), upper(i)) - d(i);
      if (move == 0) continue;
      d(i) += move;
      slope += 2 * move * H.col(i);
      largest_move = std::max(largest_move, std::abs(move) / (std::abs(d(i)) + kMoveTolerance));
    }
    if (largest_move < kMoveTolerance) break;
  }
  return d;
}

double quadratic_gap(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                     const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                     const Eigen::VectorXd& d) {
  const Eigen::VectorXd slope = 2 * H * d + g;
  double gap = 0;
  for (Eigen::Index i = 0; i < d.size(); ++i)
    if (slope(i) != 0) gap += slope(i) * (d(i) - (slope(i) > 0 ? lower(i) : upper(i)));
  return gap;
}

BoundedFitResult bounded_least_squares(const BoundedFit& fit, const Eigen::VectorXd& x0,
                                       const BoundedFitOptions& options) {
  BoundedFitResult current;
  // Start within the bounds.
  current.x = x0.cwiseMax(fit.lower).cwiseMin(fit.upper);
  current.residuals = fit.residuals(current.x, Sensitivities::kWith);
  current.possible = current.residuals.possible;
  if (!current.possible) return current;
  current.cost = current.residuals.r.squaredNorm() + fit.price.dot(current.x);
  double radius = options.max_radius;
  // Take steps within the trust region.
  for (; current.steps < options.max_steps && radius > kMinRadius; ++current.steps) {
    const Eigen::VectorXd d = trust_region_step(fit, current, radius);
    // Stop if the linearised problem predicts too little improvement.
    const double predicted = predicted_change(fit, current, d);
    const double min_decrease =
        std::max(options.tolerance, options.relative_tolerance * std::abs(current.cost));
    current.converged = -predicted < min_decrease && current.gap <= std::max(min_decrease, kMinGap);
    if (-predicted < min_decrease) break;
    // Evaluate the step, and compare actual and predicted change.
    const Eigen::VectorXd x = (current.x + d).cwiseMax(fit.lower).cwiseMin(fit.upper);
    FitResiduals next = fit.residuals(x, Sensitivities::kWith);
    const double cost = next.possible ? next.r.squaredNorm() + fit.price.dot(x) : 0;
    const double ratio = next.possible ? (cost - current.cost) / predicted : -1;
    // Adapt the trust region; reject bad steps.
    if (ratio < 0.25) radius = 0.3 * d.cwiseAbs().maxCoeff();
    if (ratio > 0.75) radius = std::min(2 * radius, options.max_radius);
    if (ratio < 1e-3) continue;
    current.x = x;
    current.cost = cost;
    current.residuals = std::move(next);
  }
  return current;
}

}  // namespace thenar
