#pragma once

#include "posterior/run/sample_posterior.h"

namespace thenar {

/// Judges the draws of a run and shares them out among its modes: fills
/// `convergence` and `mode_table`. Nothing if there are no draws.
void assess_run(PosteriorRun& run);

}  // namespace thenar
