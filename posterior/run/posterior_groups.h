#pragma once

/// The groups of a posterior file, each an InferenceGroup of ArviZ's name.

#include "data/io/inference_file.h"
#include "posterior/run/sample_posterior.h"

namespace thenar::internal {

/// Every parameter that moves, by family, of the population and of each specimen.
/// @param x  (size, chains * draws), chain by chain
[[nodiscard]] InferenceGroup parameter_group(const HandPosterior& posterior,
                                             const Eigen::MatrixXd& x, int chains);
[[nodiscard]] InferenceGroup coordinate_group(const PosteriorRun& run);  // x as it was sampled
[[nodiscard]] InferenceGroup statistics_group(const PosteriorRun& run);  // of every step
[[nodiscard]] InferenceGroup likelihood_group(const PosteriorRun& run);  // of every observation
[[nodiscard]] InferenceGroup predictive_group(const PosteriorRun& run);  // replicated forces
[[nodiscard]] InferenceGroup observed_group(const PosteriorRun& run);    // measured forces
[[nodiscard]] InferenceGroup noise_group(const PosteriorRun& run);       // their stated sds
[[nodiscard]] InferenceGroup mode_group(const PosteriorRun& run);        // found before sampling

}  // namespace thenar::internal
