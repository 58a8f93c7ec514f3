#pragma once

/// What to ask of `thenar fit --method mcmc` next, if its chains have not converged.

#include <string>
#include <vector>

#include "posterior/run/sample_posterior.h"

namespace thenar {

/// Options that answer what is wrong, each a sentence; none if nothing is.
[[nodiscard]] std::vector<std::string> advise(const PosteriorRun& run);

}  // namespace thenar
