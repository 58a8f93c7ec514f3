#pragma once

/// A posterior in words and numbers.

#include <nlohmann/json.hpp>

#include "posterior/run/sample_posterior.h"

namespace thenar {

/// Everything below, for programs.
[[nodiscard]] nlohmann::json summary_json(const PosteriorRun& run);

/// Tables: predictive checks, leave-one-out, parameters, directions, modes; a banner first if the
/// chains have not converged.
void print_summary(const PosteriorRun& run, std::size_t rows = 20);

/// @throws Error with every reason, and what may help, if the run has not converged; a warning on
/// stderr where that is allowed.
void require_converged(const PosteriorRun& run, bool allowed);

}  // namespace thenar
