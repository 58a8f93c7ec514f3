#include "posterior/run/posterior_summary.h"

#include <fmt/format.h>

#include "base/error.h"
#include "kinematics_fit/misfit.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/predict_draws.h"

namespace thenar {
namespace {

constexpr long kCheckedDraws =
    2000;  // maximum number of replicated draws for the predictive checks

/// Returns covariances of all draws and of two halves: whole chains, or the ends of a single chain.
PosteriorCovariances covariances_of(const Draws& draws) {
  const Eigen::MatrixXd all = pooled(draws);
  const Eigen::Index chains = draws.chains();
  const Eigen::Index half = chains > 1 ? chains / 2 * draws.draws() : all.cols() / 2;
  if (half < 2 || all.cols() - half < 2)
    return {covariance_of(all), covariance_of(all), covariance_of(all)};
  return {covariance_of(all), covariance_of(all.leftCols(half)),
          covariance_of(all.rightCols(all.cols() - half))};
}

/// Computes the learnt directions; the prior of the sampled coordinates is standard normal.
LearntDirections directions_of(const PosteriorRun& run) {
  const Eigen::Index n = run.draws.size();
  return learnt_directions(run.posterior->names(), covariances_of(run.draws),
                           Eigen::MatrixXd::Identity(n, n));
}

/// Checks one experiment against its replicates.
ExperimentCheck check_of(const PosteriorRun& run, const Experiment& experiment) {
  const int specimen = find_specimen(run.posterior->problem(), experiment.specimen);
  const PredictedDraws predicted = predict_draws(run, experiment, specimen, kCheckedDraws);
  // Select the fitted components of each trial.
  std::vector<Eigen::Index> rows;
  std::vector<double> measured;
  for (std::size_t i = 0; i < experiment.trials.size(); ++i)
    for (int c = 0; c < experiment.components; ++c) {
      rows.push_back(3 * static_cast<Eigen::Index>(i) + c);
      measured.push_back(experiment.trials[i].force[c]);
    }
  return {summarise(predicted),
          check_predictive(Eigen::Map<const Eigen::VectorXd>(
                               measured.data(), static_cast<Eigen::Index>(measured.size())),
                           {predicted.expected(rows, Eigen::all),
                            predicted.replicated(rows, Eigen::all), predicted.sd(rows, Eigen::all)},
                           experiment.components)};
}

}  // namespace

std::optional<LeftOutObservations> leave_out_observations(const PosteriorRun& run) {
  if (run.draws.draws() < 4) return {};
  const Eigen::MatrixXd pointwise = run.posterior->pointwise(pooled(run.draws));
  if (!pointwise.allFinite()) return {};
  return LeftOutObservations{leave_one_out(pointwise, run.draws.chains(), run.draws.group),
                             observation_names(run.posterior->problem())};
}

std::vector<std::string> noise_warnings(const std::vector<PosteriorQuantity>& quantities,
                                        const std::vector<Estimate>& estimates) {
  constexpr double kWarnedNoiseFactor =
      2;  // smallest factor on the stated noise that is reported [1]
  const std::string prefix = "noise/";
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const std::string& name = quantities[i].name;
    if (name.compare(0, prefix.size(), prefix) != 0 || !(estimates[i].q05 > kWarnedNoiseFactor))
      continue;
    warnings.push_back(fmt::format(
        "experiment '{}': its forces scatter by {:.1f} times the stated noise (5 to 95 %: {:.1f} "
        "to {:.1f}), and p and the intervals are of that larger noise. {}",
        name.substr(prefix.size()), estimates[i].median, estimates[i].q05, estimates[i].q95,
        kMisfitAdvice));
  }
  return warnings;
}

PosteriorSummary summarise_posterior(const PosteriorRun& run) {
  require(run.draws.draws() * run.draws.chains() >= 2, "a summary needs 2 draws, got {}",
          run.draws.draws() * run.draws.chains());
  // Compute quantities with their estimates, and the directions that the data determine.
  PosteriorSummary summary;
  summary.quantities = posterior_quantities(run);
  summary.estimates = estimates_of(summary.quantities, run.draws.group);
  summary.axes = posterior_axes(run);
  summary.directions = directions_of(run);
  // Compare experiments with their replicates, and predict left-out observations.
  for (const Experiment& experiment : run.posterior->problem().experiments())
    if (!experiment.trials.empty()) summary.experiments.push_back(check_of(run, experiment));
  summary.left_out = leave_out_observations(run);
  return summary;
}

}  // namespace thenar
