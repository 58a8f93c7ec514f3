#pragma once

/// A sampled posterior as words, JSON and rows.

#include <string>

#include "api/posterior.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {

/// Whether the sampler has converged, predicted forces beside those measured, leave-one-out,
/// parameters, directions and modes.
[[nodiscard]] std::string text_of(const PosteriorResult& result);

/// The same in full, numbers as they are.
[[nodiscard]] OrderedJson json_of(const PosteriorResult& result);

/// One row for each parameter and factor, best known first.
[[nodiscard]] Table table_of(const PosteriorResult& result);

/// What the draws predict: words, JSON and rows as of any prediction.
[[nodiscard]] std::string text_of(const PosteriorPrediction& result);
[[nodiscard]] OrderedJson json_of(const PosteriorPrediction& result);
[[nodiscard]] Table table_of(const PosteriorPrediction& result);

/// Why the draws are not to be used, with ways out and the commands for them; "" if they are.
/// @param allowed  the person asked for them all the same
[[nodiscard]] std::string convergence_complaint(const PosteriorRun& run, bool allowed);

/// What a reader of converged draws should know, with ways out; often nothing.
[[nodiscard]] std::vector<std::string> convergence_cautions(const PosteriorRun& run);

/// Of experiments whose forces scatter far beyond the stated noise; see noise_warnings(). Nothing
/// without a summary.
[[nodiscard]] std::vector<std::string> noise_cautions(const PosteriorResult& result);

}  // namespace thenar
