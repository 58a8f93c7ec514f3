#pragma once

/// A posterior in words and numbers.

#include <nlohmann/json.hpp>

#include "posterior/run/sample_posterior.h"

namespace thenar {

[[nodiscard]] nlohmann::json summary_json(const PosteriorRun& run);

/// Tables of parameters, modes, directions and chains; a banner first if they
/// have not converged.
void print_summary(const PosteriorRun& run, std::size_t rows = 20);

/// @throws Error with every reason if the run has not converged and that is not
/// allowed.
void require_converged(const PosteriorRun& run, bool allowed);

}  // namespace thenar
