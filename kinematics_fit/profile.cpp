#include "kinematics_fit/profile.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "kinematics_fit/fit_residuals.h"

namespace thenar {
namespace {

/// Refits at points from the estimate to one end of the grid, each starting from the last.
void refit_side(const LeastSquares& problem, const Eigen::VectorXd& z, int i, double end,
                const ProfileOptions& options, Profile& profile) {
  // Length below which a side is skipped, as the estimate is on its bound [prior sds]
  constexpr double kMinSideLength = 1e-6;
  if (std::abs(end - z[i]) < kMinSideLength) return;
  LeastSquares held = problem;
  Eigen::VectorXd start = z;
  for (int k = 1; k <= options.steps && !options.solver.progress.stop(); ++k) {
    // Fix the coordinate by equal bounds; start the others at the last solution.
    const double value = z[i] + (end - z[i]) * k / options.steps;
    held.lower[i] = held.upper[i] = value;
    const Solution fit = solve(held, start, options.solver);
    if (fit.status != Status::kSolved) ++profile.not_converged;
    start = fit.z;
    profile.points.push_back({value, fit.cost, 0, 0});
  }
}

/// Returns the minimum of a sampled curve: the vertex of the parabola through the lowest three
/// points.
double min_value(const std::vector<double>& x, const std::vector<double>& y) {
  // Take the lowest point if it lacks a neighbour on one side.
  const auto at = std::min_element(y.begin(), y.end()) - y.begin();
  const auto k = static_cast<std::size_t>(at);
  if (k == 0 || k + 1 == y.size()) return y[k];
  // Compute the slopes to both neighbours, and the vertex of the parabola.
  const double left = (y[k] - y[k - 1]) / (x[k] - x[k - 1]);
  const double right = (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
  const double curvature = (right - left) / (x[k + 1] - x[k - 1]);
  if (!(curvature > 0)) return y[k];
  const double slope = left + curvature * (x[k] - x[k - 1]);
  return y[k] - slope * slope / (4 * curvature);
}

/// Returns the first crossing of `rise` outwards from the lowest point, linear in the root of the
/// rise.
std::optional<double> crossing(const std::vector<double>& x, const std::vector<double>& rises,
                               double rise, int direction) {
  // Search outwards for the first point beyond the wanted rise.
  const auto lowest = std::min_element(rises.begin(), rises.end()) - rises.begin();
  const auto size = static_cast<std::ptrdiff_t>(rises.size());
  for (auto k = lowest + direction; k >= 0 && k < size; k += direction) {
    const auto outer = static_cast<std::size_t>(k), inner = static_cast<std::size_t>(k - direction);
    if (rises[outer] < rise) continue;
    // Choose the sign of the root, which changes at the vertex, next to the lowest point.
    double a = std::sqrt(std::max(0.0, rises[inner]));
    const double b = std::sqrt(rises[outer]);
    const auto beyond = k - 2 * direction;
    if (inner == static_cast<std::size_t>(lowest) && beyond >= 0 && beyond < size) {
      const double c = std::sqrt(std::max(0.0, rises[beyond]));
      const double same = (b - a) / (x[outer] - x[inner]) - (a + c) / (x[inner] - x[beyond]);
      const double other = (b + a) / (x[outer] - x[inner]) - (c - a) / (x[inner] - x[beyond]);
      if (std::abs(other) < std::abs(same)) a = -a;
    }
    // Interpolate linearly in the root of the rise: exact for a parabola.
    return x[inner] + (x[outer] - x[inner]) * (std::sqrt(rise) - a) / (b - a);
  }
  return {};
}

}  // namespace

Profile profile_likelihood(const LeastSquares& problem, const Eigen::VectorXd& z, int i,
                           const ProfileOptions& options) {
  // Compute the costs on a grid to both sides of the estimate.
  require(i >= 0 && i < z.size(), "no coordinate {}: there are {}", i, z.size());
  Profile profile;
  profile.points.push_back(
      {z[i], 0.5 * problem.residuals(z, WithJacobian::kNo).r.squaredNorm(), 0, 0});
  refit_side(problem, z, i, std::max(problem.lower[i], z[i] - options.half_width), options,
             profile);
  refit_side(problem, z, i, std::min(problem.upper[i], z[i] + options.half_width), options,
             profile);
  std::sort(profile.points.begin(), profile.points.end(),
            [](const ProfilePoint& a, const ProfilePoint& b) { return a.z < b.z; });

  // Compute rises above the minimum, with and without the coordinate's own prior.
  std::vector<double> x, cost, without_own_prior;
  for (const ProfilePoint& point : profile.points) {
    x.push_back(point.z);
    cost.push_back(point.cost);
    without_own_prior.push_back(point.cost - 0.5 * point.z * point.z);
  }
  const double base = min_value(x, cost), own_free_base = min_value(x, without_own_prior);
  for (std::size_t k = 0; k < x.size(); ++k) {
    cost[k] = profile.points[k].rise = cost[k] - base;
    without_own_prior[k] = profile.points[k].without_own_prior =
        without_own_prior[k] - own_free_base;
  }

  // Find where the rises cross the limit.
  profile.bounds = {crossing(x, cost, options.rise, -1), crossing(x, cost, options.rise, 1)};
  profile.without_own_prior = {crossing(x, without_own_prior, options.rise, -1),
                               crossing(x, without_own_prior, options.rise, 1)};
  return profile;
}

Profile profile_likelihood(const FitProblem& problem, const Eigen::VectorXd& z, int i,
                           const ProfileOptions& options) {
  Profile profile = profile_likelihood(least_squares(problem), z, i, options);
  profile.name = problem.coordinates().names()[i];
  return profile;
}

}  // namespace thenar
