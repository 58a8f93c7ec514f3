#include "posterior/run/posterior_quantities.h"

#include <cmath>

#include <fmt/format.h>

#include "base/lists.h"
#include "kinematics_fit/prediction.h"
#include "posterior/hand_posterior.h"

namespace thenar {

Eigen::MatrixXd reshape_by_chain(const Eigen::VectorXd& values, int chains) {
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), values.size() / chains, chains);
}

double prior_sd(const PosteriorQuantity& quantity) {
  const Eigen::ArrayXd off = quantity.prior.array() - quantity.prior.mean();
  return std::sqrt(off.square().sum() / static_cast<double>(off.size() - 1));
}

Eigen::MatrixXd prior_draws(const PosteriorRun& run, int count) {
  Eigen::MatrixXd prior(run.posterior->size(), count);
  for (int k = 0; k < count; ++k)
    prior.col(k) =
        run.posterior->draw_prior(run.settings.run.sampler.seed, static_cast<unsigned>(k));
  return prior;
}

std::vector<PosteriorQuantity> posterior_quantities(const PosteriorRun& run, int prior_count) {
  // Compute values at all draws, and at draws from the prior.
  const HandPosterior& posterior = *run.posterior;
  const FitProblem& problem = posterior.problem();
  const PosteriorValues values = posterior.values(pooled(run.draws));
  const PosteriorValues prior = posterior.values(prior_draws(run, prior_count));
  const std::vector<int> moving = posterior.moving_parameters();
  const int chains = run.draws.chains();

  // Add parameters of the population or a specimen.
  std::vector<PosteriorQuantity> found;
  const auto add_parameters = [&](const std::string& whose, const Eigen::MatrixXd& drawn,
                                  const Eigen::MatrixXd& before) {
    for (Eigen::Index i = 0; i < drawn.rows(); ++i) {
      // Convert to display units.
      const auto at = static_cast<std::size_t>(moving[i]);
      const Parameter& p = problem.parameters().all[at];
      const double scale = display_scale(p);
      // Parameters of the mounting belong to specimens: the population has none.
      if (before.row(i).minCoeff() == before.row(i).maxCoeff()) continue;
      found.push_back({whose + p.name, display_unit(p),
                       scale * reshape_by_chain(drawn.row(i), chains),
                       scale * before.row(i).transpose()});
    }
  };
  // Add the population only if it differs from the specimen.
  const bool several = problem.specimens().size() > 1;
  if (several) add_parameters("", values.population, prior.population);
  for (std::size_t s = 0; s < problem.specimens().size(); ++s)
    add_parameters(several ? problem.specimens()[s] + ": " : "", values.specimens[s],
                   prior.specimens[s]);

  // Add factors of noise and between specimens.
  const auto add_factors = [&](const std::string& kind, const std::vector<std::string>& names,
                               const Eigen::MatrixXd& drawn, const Eigen::MatrixXd& before) {
    for (Eigen::Index i = 0; i < drawn.rows(); ++i)
      found.push_back({kind + names[i], "1", reshape_by_chain(drawn.row(i), chains),
                       before.row(i).transpose()});
  };
  if (run.settings.posterior.learn_noise)
    add_factors("noise/", experiment_names(problem), values.noise, prior.noise);
  add_factors("spread/", posterior.specimen_scale_kinds(), values.specimen_scale,
              prior.specimen_scale);
  return found;
}

std::vector<std::string> experiment_names(const FitProblem& problem) {
  return names_of(problem.experiments());
}

std::vector<std::string> observation_names(const FitProblem& problem, Observed which) {
  std::vector<std::string> names;
  // Trials of all experiments come first, then their rows of muscle activations.
  for (const Experiment& experiment : problem.experiments())
    for (const Trial& trial : experiment.trials)
      names.push_back(
          fmt::format("{}: {} {}", experiment.name, trial.posture, describe_loads(trial)));
  if (which == Observed::kForces) return names;
  for (const Experiment& experiment : problem.experiments())
    for (const ActivationRow& row : experiment.activations)
      names.push_back(fmt::format("{}: {} muscle activity", experiment.name, row.posture));
  return names;
}

std::vector<Estimate> estimates_of(const std::vector<PosteriorQuantity>& quantities,
                                   const std::vector<int>& group) {
  return transformed(quantities,
                     [&](const PosteriorQuantity& q) { return estimate(q.name, q.draws, group); });
}

}  // namespace thenar
