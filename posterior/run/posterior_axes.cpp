#include "posterior/run/posterior_axes.h"

#include "base/lists.h"
#include "base/units.h"
#include "kinematics_fit/model/predict_forces.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/posterior_quantities.h"

namespace thenar {
namespace {

/// Returns whether a parameter moves the axis of a hinge.
bool moves_axis(const Parameter& p, int hinge) {
  return (p.kind == ParameterKind::kAxisDirection || p.kind == ParameterKind::kAxisPoint) &&
         p.item == hinge;
}

/// Returns neighbouring axes of which a moving parameter moves at least one.
std::vector<NeighbouringAxes> moving_axes(const HandPosterior& posterior) {
  const FitProblem& problem = posterior.problem();
  const std::vector<int> moving = posterior.moving_parameters();
  std::vector<NeighbouringAxes> pairs = neighbouring_axes(problem.digit());
  erase_where(pairs, [&](const NeighbouringAxes& pair) {
    return !any_of(moving, [&](int p) {
      const Parameter& parameter = problem.parameters().all[p];
      return moves_axis(parameter, pair.first) || moves_axis(parameter, pair.second);
    });
  });
  return pairs;
}

/// Computes angle [deg], distance and offset beyond [mm] of each pair in turn at every point.
/// @param values  parameters that move [SI] (parameters, points)
/// @return (points, 3 pairs)
Eigen::MatrixXd axis_offsets(const HandPosterior& posterior,
                             const std::vector<NeighbouringAxes>& pairs,
                             const Eigen::MatrixXd& values) {
  const FitParameters& parameters = posterior.problem().parameters();
  const std::vector<int> moving = posterior.moving_parameters();
  Eigen::MatrixXd offsets(values.cols(), 3 * static_cast<Eigen::Index>(pairs.size()));
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    // Build the digit at this point, and compare its axes.
    const SpecimenModel<double> at = specimen_model<double>(
        posterior.problem().digit(), parameters, values_with(parameters, moving, values.col(k)));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const AxisOffset offset = axis_offset(at.digit, pairs[i]);
      const auto column = 3 * static_cast<Eigen::Index>(i);
      offsets.row(k).segment<3>(column) << degrees(offset.angle), 1e3 * offset.distance,
          1e3 * offset.beyond;
    }
  }
  return offsets;
}

double share_above_zero(const Eigen::VectorXd& values) {
  return static_cast<double>((values.array() > 0).count()) / static_cast<double>(values.size());
}

}  // namespace

std::vector<PosteriorAxes> posterior_axes(const PosteriorRun& run, int prior_count) {
  const HandPosterior& posterior = *run.posterior;
  const std::vector<NeighbouringAxes> pairs = moving_axes(posterior);
  std::vector<PosteriorAxes> found;
  if (pairs.empty()) return found;
  const PosteriorValues drawn = posterior.values(pooled(run.draws));
  const PosteriorValues before = posterior.values(prior_draws(run, prior_count));
  const int chains = run.draws.chains();

  // Add the offsets of the population or a specimen.
  const auto add = [&](const std::string& whose, const Eigen::MatrixXd& values,
                       const Eigen::MatrixXd& prior_values) {
    const Eigen::MatrixXd offsets = axis_offsets(posterior, pairs, values);
    const Eigen::MatrixXd prior = axis_offsets(posterior, pairs, prior_values);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto column = 3 * static_cast<Eigen::Index>(i);
      // Axes that only specimens move are constant in the population.
      const Eigen::MatrixXd spread = prior.middleCols<3>(column);
      if ((spread.rowwise() - spread.row(0)).isZero(0)) continue;
      const auto estimate_of = [&](Eigen::Index component) {
        return estimate(pairs[i].name, reshape_by_chain(offsets.col(column + component), chains),
                        run.draws.group);
      };
      found.push_back({whose, pairs[i], estimate_of(0), estimate_of(1), estimate_of(2),
                       share_above_zero(offsets.col(column + 2)),
                       share_above_zero(prior.col(column + 2))});
    }
  };
  // Add the population only if it differs from the specimen.
  const std::vector<std::string>& specimens = posterior.problem().specimens();
  const bool several = specimens.size() > 1;
  if (several) add("", drawn.population, before.population);
  for (std::size_t s = 0; s < specimens.size(); ++s)
    add(several ? specimens[s] : "", drawn.specimens[s], before.specimens[s]);
  return found;
}

}  // namespace thenar
