#pragma once

/// The page of the demo: fits, posteriors, hoods and thumbs on real data.

#include <string>
#include <vector>

#include "api/demo.h"
#include "report/blocks.h"

namespace thenar {

/// All sections in one page: accuracy, forces, solvers, parameters, the finger, its population, the
/// hood, thumbs, posteriors and the study of a thumb; `more` sections stand at its end.
/// @param seconds  that the whole took [s]
[[nodiscard]] Json demo_page(const DemoResult& demo, const Json& more, double seconds);

/// Errors of every posterior on every experiment, seen or not, and figures of its chains.
[[nodiscard]] Json posteriors_at_a_glance(const std::vector<DemoPosterior>& posteriors);

/// Thumbs side by side: axes, feasible thumbtip forces, largest forces along the thumb's own
/// directions.
[[nodiscard]] Json thumb_page(const std::vector<DemoThumb>& thumbs);

/// A line for each specimen: its relative error in sample and left out; and where the page is.
/// @param page  absolute path
[[nodiscard]] std::string demo_text(const DemoResult& demo, const std::string& page,
                                    double seconds);

}  // namespace thenar
