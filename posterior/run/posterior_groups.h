#pragma once

/// Groups of a posterior file, each an InferenceGroup under ArviZ's name.

#include "data/io/inference_file.h"
#include "posterior/run/sample_posterior.h"

namespace thenar::internal {

/// Returns the parameters that move, by kind and in display units [mm, deg, 1, 1/rad], of the
/// population and of each specimen, and the factors of noise and between specimens [1].
/// @param x  points of the posterior, chain by chain [1] (size, chains * draws)
[[nodiscard]] InferenceGroup parameter_group(const HandPosterior& posterior,
                                             const Eigen::MatrixXd& x, int chains);
/// Returns the draws of x as sampled, in prior sds [1].
[[nodiscard]] InferenceGroup coordinate_group(const PosteriorRun& run);
/// Calls `use` with the name, description and member of each recorded field of StepStats.
template <typename Use>
void each_step_field(const Use& use) {
  use("log_prior", "log prior", &StepStats::log_prior);
  use("log_likelihood", "log likelihood", &StepStats::log_likelihood);
  use("acceptance_rate", "mean probability of acceptance", &StepStats::acceptance);
  use("step_size", "of the leapfrog", &StepStats::step_size);
  use("energy", "Hamiltonian", &StepStats::energy);
  use("tree_depth", "of the trajectory", &StepStats::depth);
  use("n_steps", "densities asked for", &StepStats::evaluations);
  use("broken", "densities that were NaN", &StepStats::non_finite);
  use("diverging", "energy error above 1000", &StepStats::divergent);
}
/// Returns the statistics of every recorded step, see StepStats.
[[nodiscard]] InferenceGroup statistics_group(const PosteriorRun& run);
/// Returns the log likelihood of every trial and every row of muscle activations [1].
[[nodiscard]] InferenceGroup likelihood_group(const PosteriorRun& run);
/// Returns replicated forces of the trials for at most 1000 draws of each chain [N].
[[nodiscard]] InferenceGroup predictive_group(const PosteriorRun& run);
/// Returns the measured forces of the trials [N].
[[nodiscard]] InferenceGroup observed_group(const PosteriorRun& run);
/// Returns the stated sds of the forces [N].
[[nodiscard]] InferenceGroup noise_group(const PosteriorRun& run);
/// Returns the modes found before sampling: point, cost, number of searches and Laplace mass [1].
[[nodiscard]] InferenceGroup mode_group(const PosteriorRun& run);

}  // namespace thenar::internal
