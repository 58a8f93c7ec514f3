#include "posterior/gauge.h"

#include <algorithm>

#include "kinematics_fit/specimen_prior.h"

namespace thenar {
namespace {

/// Returns the index of a parameter; -1 if the digit has none of this kind.
int find_parameter(const FitParameters& parameters, ParameterKind kind, int item, int component) {
  for (std::size_t p = 0; p < parameters.all.size(); ++p) {
    const Parameter& one = parameters.all[p];
    if (one.kind == kind && one.item == item && one.component == component)
      return static_cast<int>(p);
  }
  return -1;
}

/// Returns the coordinate that moves this parameter and no other; -1 if there is none.
int own_coordinate(const FitParameters& parameters, int parameter) {
  const int c = parameters.coordinate[parameter];
  const auto users = std::count(parameters.coordinate.begin(), parameters.coordinate.end(), c);
  return c >= 0 && users == 1 ? c : -1;
}

/// Returns whether a point's coordinate can compensate for shifts along a tilted axis: it must move
/// wherever the shift does, and differ between specimens if their tilts do.
bool takes_up(const FitProblem& problem, int point, int along, int tilt) {
  if (point < 0) return false;
  const CoordinateEntries &a = problem.coordinates().entries(along),
                          &b = problem.coordinates().entries(point);
  const bool differ =
      a.deviation >= 0 || (tilt >= 0 && problem.coordinates().entries(tilt).deviation >= 0);
  return (a.population < 0 || b.population >= 0) && (!differ || b.deviation >= 0);
}

/// Returns the value of a tilt [rad].
double tilt(const FitParameters& parameters, int parameter, const Eigen::VectorXd& u) {
  const int c = parameters.coordinate[parameter];
  return parameters.all[parameter].mean + (c < 0 ? 0 : parameters.ratio[parameter] * u[c]);
}

/// Returns displacements of kPopulation or a specimen, the former without the factor
/// population_share().
Eigen::VectorXd whole_displacements(const FitProblem& problem, const Eigen::VectorXd& z,
                                    int specimen) {
  if (specimen >= 0) return displacements(problem.coordinates(), z, specimen);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(problem.parameters().coordinates());
  for (int c = 0; c < static_cast<int>(u.size()); ++c) {
    // The population share belongs to the estimate, not to the geometry.
    const CoordinateEntries& coordinate = problem.coordinates().entries(c);
    if (coordinate.population >= 0) u[c] = coordinate.population_sd * z[coordinate.population];
  }
  return u;
}

}  // namespace

std::vector<Gauge> find_gauges(const FitProblem& problem) {
  const FitParameters& parameters = problem.parameters();
  std::vector<Gauge> gauges;
  for (int p = 0; p < static_cast<int>(parameters.all.size()); ++p) {
    // Candidates are shifts of an axis along itself that move nothing else.
    const Parameter& one = parameters.all[p];
    if (one.kind != ParameterKind::kAxisPoint || one.component != 2) continue;
    Gauge gauge{own_coordinate(parameters, p), {-1, -1}, {-1, -1}};
    if (gauge.along < 0) continue;

    // Check whether the axis is tilted, and whether its point can compensate in both directions.
    bool tilted = false, free = true;
    for (int k = 0; k < 2; ++k) {
      gauge.tilt[k] = find_parameter(parameters, ParameterKind::kAxisDirection, one.item, k);
      const int turn = parameters.coordinate[gauge.tilt[k]];
      tilted |= turn >= 0 || parameters.all[gauge.tilt[k]].mean != 0;
      const int point = find_parameter(parameters, ParameterKind::kAxisPoint, one.item, k);
      gauge.point[k] = own_coordinate(parameters, point);
      free &= takes_up(problem, gauge.point[k], gauge.along, turn);
    }

    // Without tilt the shift has no effect, and needs no compensation.
    if (!tilted) gauge.point[0] = gauge.point[1] = -1;
    if (free || !tilted) gauges.push_back(gauge);
  }
  return gauges;
}

Eigen::VectorXd without_gauges(const FitProblem& problem, const std::vector<Gauge>& gauges,
                               Eigen::VectorXd z) {
  // Compute all changes from the original z.
  const Eigen::VectorXd before = z;
  const FitParameters& parameters = problem.parameters();
  const int specimens = static_cast<int>(problem.specimens().size());
  const Eigen::VectorXd population = whole_displacements(problem, before, kPopulation);
  for (const Gauge& gauge : gauges) {
    // Change of the point that replaces the shift s of a tilted axis: -s u, -s v.
    const auto shift = [&](const Eigen::VectorXd& u, int k) {
      return -u[gauge.along] * tilt(parameters, gauge.tilt[k], u);
    };

    // Set the shift to zero, for the population and for every specimen.
    const CoordinateEntries& along = problem.coordinates().entries(gauge.along);
    if (along.population >= 0) z[along.population] = 0;
    for (int s = 0; s < specimens && along.deviation >= 0; ++s)
      z[along.deviation + s * problem.coordinates().deviations()] = 0;

    // Move the point instead: first for the population, then for specimens relative to it.
    for (int k = 0; k < 2 && gauge.point[k] >= 0; ++k) {
      const int c = gauge.point[k];
      const CoordinateEntries& point = problem.coordinates().entries(c);
      double common = 0;
      if (point.population >= 0) {
        common = population[c] + shift(population, k);
        z[point.population] = common / point.population_sd;
      }
      for (int s = 0; s < specimens && point.deviation >= 0; ++s) {
        const Eigen::VectorXd u = whole_displacements(problem, before, s);
        z[point.deviation + s * problem.coordinates().deviations()] =
            deviation_entry(point, common, u[c] + shift(u, k) - common);
      }
    }
  }
  return z;
}

}  // namespace thenar
