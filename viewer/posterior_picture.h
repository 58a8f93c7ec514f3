#pragma once

/// A sampled posterior as the picture that posterior_sections() draws.

#include <map>
#include <string>

#include "posterior/run/sample_posterior.h"
#include "viewer/posterior_page.h"

namespace thenar {

/// @param title  heads the sections
/// @param truth  values that the data were made with, by parameter [display
/// unit]; empty: unknown
[[nodiscard]] PosteriorPicture posterior_picture(const PosteriorRun& run, const std::string& title,
                                                 const std::map<std::string, double>& truth = {});

}  // namespace thenar
