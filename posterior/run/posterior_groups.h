#pragma once

/// Groups of a posterior file, each an InferenceGroup under ArviZ's name.

#include "data/io/inference_file.h"
#include "posterior/run/sample_posterior.h"

namespace thenar::internal {

/// Parameters that move, by kind and in display units [mm, deg, 1, 1/rad], of the population and of
/// each specimen; factors of noise and between specimens [1].
/// @param x  points of the posterior, chain by chain [1] (size, chains * draws)
[[nodiscard]] InferenceGroup parameter_group(const HandPosterior& posterior,
                                             const Eigen::MatrixXd& x, int chains);
/// Draws of x as sampled, in prior sds [1].
[[nodiscard]] InferenceGroup coordinate_group(const PosteriorRun& run);
/// Hands each recorded field of StepStats with its name and what it is to a function that writes or
/// reads it.
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
/// Statistics of every recorded step, see StepStats.
[[nodiscard]] InferenceGroup statistics_group(const PosteriorRun& run);
/// Log likelihood of every trial and every row of muscle activations [1].
[[nodiscard]] InferenceGroup likelihood_group(const PosteriorRun& run);
/// Replicated forces of the trials, at most 1000 draws of each chain [N].
[[nodiscard]] InferenceGroup predictive_group(const PosteriorRun& run);
/// Measured forces of the trials [N].
[[nodiscard]] InferenceGroup observed_group(const PosteriorRun& run);
/// Stated sds of the forces [N].
[[nodiscard]] InferenceGroup noise_group(const PosteriorRun& run);
/// Modes found before sampling: point, cost, number of searches and Laplace mass [1].
[[nodiscard]] InferenceGroup mode_group(const PosteriorRun& run);

}  // namespace thenar::internal
