#include "kinematics_fit/specimen_prior.h"

#include <algorithm>
#include <cmath>

#include "base/bounded_normal.h"

namespace thenar {
namespace {

/// Bounds of the deviation of one specimen, in its sds.
struct DeviationBounds {
  double lower, upper;  // [1]
  bool far;             // true if no probability mass lies beyond them
};

DeviationBounds deviation_bounds(const CoordinateEntries& coordinate, double population,
                                 double sd) {
  // Distance beyond which a normal distribution has a mass of 1e-19 [sds]
  constexpr double kFarBoundDistance = 9;
  // Keep 0 inside: rounding may leave the population slightly out of bounds.
  const double lower = std::min(0.0, (coordinate.lower - population) / sd);
  const double upper = std::max(0.0, (coordinate.upper - population) / sd);
  return {lower, upper, lower < -kFarBoundDistance && upper > kFarBoundDistance};
}

}  // namespace

SpecimenDeviation specimen_deviation(const CoordinateEntries& coordinate, double population,
                                     double x, double factor) {
  // Return a normal deviation for far bounds, and none for an empty interval.
  const double sd = factor * coordinate.deviation_sd;
  const DeviationBounds bounds = deviation_bounds(coordinate, population, sd);
  if (bounds.far) return {sd * x, sd, 0, sd * x};
  if (!(bounds.lower < bounds.upper)) return {0, 0, 0, 0};

  // Map x by the truncated normal; both bounds move against the population.
  const BoundedNormal::Image image = BoundedNormal(bounds.lower, bounds.upper).evaluate(x);
  SpecimenDeviation out{sd * image.z, sd * image.by_x, -(image.by_lower + image.by_upper),
                        sd * image.z};
  // Add the effect of the sd on the bounds, which are in units of it.
  if (std::isfinite(bounds.lower)) out.by_log_factor -= sd * image.by_lower * bounds.lower;
  if (std::isfinite(bounds.upper)) out.by_log_factor -= sd * image.by_upper * bounds.upper;
  return out;
}

double deviation_entry(const CoordinateEntries& coordinate, double population, double u,
                       double factor) {
  constexpr double kBoundMargin = 1e-12;  // margin to a bound, at which x is infinite [sds]
  const double sd = factor * coordinate.deviation_sd;
  const DeviationBounds bounds = deviation_bounds(coordinate, population, sd);
  if (bounds.far) return u / sd;
  if (!(bounds.lower < bounds.upper)) return 0;
  return BoundedNormal(bounds.lower, bounds.upper).inverse(u / sd, kBoundMargin);
}

CoordinateMotion coordinate_motion(const FitCoordinates& coordinates, const Eigen::VectorXd& z,
                                   int specimen) {
  const int n = coordinates.parameters().coordinates();
  CoordinateMotion out{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n),
                       Eigen::VectorXd::Zero(n)};
  for (int c = 0; c < n; ++c) {
    // Scale the population's displacement, which all specimens share.
    const CoordinateEntries& coordinate = coordinates.entries(c);
    const double share = specimen < 0 ? coordinates.population_share(c) : 1;
    if (coordinate.population >= 0) {
      out.by_population[c] = share * coordinate.population_sd;
      out.u[c] = out.by_population[c] * z[coordinate.population];
    }
    if (coordinate.deviation < 0 || specimen < 0) continue;

    // Add the specimen's own deviation, within the bounds of the sum.
    const double x = z[coordinate.deviation + specimen * coordinates.deviations()];
    const SpecimenDeviation own = specimen_deviation(coordinate, out.u[c], x);
    out.u[c] += own.u;
    out.by_population[c] *= 1 + own.by_population;
    out.by_deviation[c] = own.by_x;
  }
  return out;
}

Eigen::VectorXd displacements(const FitCoordinates& coordinates, const Eigen::VectorXd& z,
                              int specimen) {
  return coordinate_motion(coordinates, z, specimen).u;
}

Eigen::MatrixXd displacement_jacobian(const FitCoordinates& coordinates, const Eigen::VectorXd& z,
                                      int specimen) {
  // Fill in the two columns at most that are not zero in each row.
  const CoordinateMotion at = coordinate_motion(coordinates, z, specimen);
  const int n = coordinates.parameters().coordinates();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(
      n, coordinates.population_entries() + (specimen < 0 ? 0 : coordinates.deviations()));
  for (int c = 0; c < n; ++c) {
    const CoordinateEntries& coordinate = coordinates.entries(c);
    if (coordinate.population >= 0) J(c, coordinate.population) = at.by_population[c];
    if (coordinate.deviation >= 0 && specimen >= 0) J(c, coordinate.deviation) = at.by_deviation[c];
  }
  return J;
}

Eigen::VectorXd unseen_variance(const FitCoordinates& coordinates) {
  const FitParameters& parameters = coordinates.parameters();
  Eigen::VectorXd variance(parameters.coordinates());
  for (int c = 0; c < parameters.coordinates(); ++c) {
    const Parameter& p = parameters.all[parameters.leader[c]];
    // Add what a sum of two normals leaves of each: share (1 - share) of its variance.
    const double share = coordinates.population_share(c);
    const double unsaid = share * (1 - share) * std::pow(coordinates.entries(c).population_sd, 2);
    variance[c] = unsaid + std::pow(p.between_sd, 2);
  }
  return variance;
}

}  // namespace thenar
