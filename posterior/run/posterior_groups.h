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
