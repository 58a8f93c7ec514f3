#include "solvers/bounded_least_squares.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thenar {
namespace {

constexpr double kLeastRadius = 1e-9;  // trust radius below which the fit ends
constexpr int kMostSweeps = 400;       // maximum number of sweeps of coordinate descent
// Relative move in a sweep below which coordinate descent has converged [1]
constexpr double kSettledMove = 1e-9;

// Gap of a linearised problem that further sweeps do not reduce
constexpr double kGapRounding = 1e-6;

/// Returns the minimiser of the linearised problem in the trust region, and stores its gap in
/// `now`.
Eigen::VectorXd trusted_step(const BoundedFit& fit, BoundedFitResult& now, double radius) {
  // Gauss-Newton Hessian, slightly regularised.
  Eigen::MatrixXd H = now.at.J.transpose() * now.at.J;
  H.diagonal().array() += 1e-9 * H.diagonal().maxCoeff() + 1e-12;
  const Eigen::VectorXd g = 2 * now.at.J.transpose() * now.at.r + fit.price;
  // Intersect bounds and trust region.
  const Eigen::VectorXd lower = (fit.lower - now.x).cwiseMax(-radius);
  const Eigen::VectorXd upper = (fit.upper - now.x).cwiseMin(radius);
  Eigen::VectorXd d = bounded_quadratic(H, g, lower, upper);
  now.gap = quadratic_gap(H, g, lower, upper, d);
  return d;
}

/// Returns the change of the cost that the linearised problem predicts for a step.
double foreseen_change(const BoundedFit& fit, const BoundedFitResult& now,
                       const Eigen::VectorXd& d) {
  return (now.at.r + now.at.J * d).squaredNorm() - now.at.r.squaredNorm() + fit.price.dot(d);
}

}  // namespace

Eigen::VectorXd bounded_quadratic(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                  const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  // Coordinate descent from the feasible point nearest to zero.
  Eigen::VectorXd d = Eigen::VectorXd::Zero(g.size()).cwiseMax(lower).cwiseMin(upper);
  Eigen::VectorXd slope = 2 * H * d + g;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double moved = 0;
    for (Eigen::Index i = 0; i < g.size(); ++i) {
      const double wanted = d(i) - slope(i) / (2 * H(i, i));
      const double move = std::clamp(wanted, lower(i), upper(i)) - d(i);
      if (move == 0) continue;
      d(i) += move;
      slope += 2 * move * H.col(i);
      moved = std::max(moved, std::abs(move) / (std::abs(d(i)) + kSettledMove));
    }
    if (moved < kSettledMove) break;
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
  BoundedFitResult now;
  // Start within the bounds.
  now.x = x0.cwiseMax(fit.lower).cwiseMin(fit.upper);
  now.at = fit.residuals(now.x, Sensitivities::kWith);
  now.possible = now.at.possible;
  if (!now.possible) return now;
  now.cost = now.at.r.squaredNorm() + fit.price.dot(now.x);
  double radius = options.radius;
  // Take steps within the trust region.
  for (; now.steps < options.max_steps && radius > kLeastRadius; ++now.steps) {
    const Eigen::VectorXd d = trusted_step(fit, now, radius);
    // Stop if the linearised problem predicts too little improvement.
    const double foreseen = foreseen_change(fit, now, d);
    const double small = std::max(options.tolerance, options.relative * std::abs(now.cost));
    now.converged = -foreseen < small && now.gap <= std::max(small, kGapRounding);
    if (-foreseen < small) break;
    // Evaluate the step, and compare actual and predicted change.
    const Eigen::VectorXd x = (now.x + d).cwiseMax(fit.lower).cwiseMin(fit.upper);
    FitResiduals next = fit.residuals(x, Sensitivities::kWith);
    const double cost = next.possible ? next.r.squaredNorm() + fit.price.dot(x) : 0;
    const double ratio = next.possible ? (cost - now.cost) / foreseen : -1;
    // Adapt the trust region; reject bad steps.
    if (ratio < 0.25) radius = 0.3 * d.cwiseAbs().maxCoeff();
    if (ratio > 0.75) radius = std::min(2 * radius, options.radius);
    if (ratio < 1e-3) continue;
    now.x = x;
    now.cost = cost;
    now.at = std::move(next);
  }
  return now;
}

}  // namespace thenar
