#pragma once

/// A posterior as ArviZ InferenceData; the layout is in docs/data_format.md.

#include <string>

#include "data/io/inference_file.h"
#include "posterior/run/sample_posterior.h"

namespace thenar {

/// Parameters, statistics of the sampler, pointwise log likelihood, replicated and measured
/// forces, draws from the prior, and everything needed to run it again.
[[nodiscard]] InferenceFile describe_posterior(const PosteriorRun& run);

/// Writes to a temporary file and renames it when complete.
void write_posterior(const PosteriorRun& run, const std::string& path);

/// Rebuilds the posterior from the inputs in the file and takes the draws from it.
/// @throws DataError if the file is not a posterior that thenar wrote.
[[nodiscard]] PosteriorRun read_posterior(const std::string& path);

}  // namespace thenar
