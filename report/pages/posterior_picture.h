#pragma once

/// A sampled posterior as the picture that posterior_sections() draws.

#include <map>
#include <string>

#include "posterior/run/sample_posterior.h"
#include "report/pages/posterior.h"

namespace thenar {

struct PictureOptions {
  std::string title;                    // heads the sections
  std::string prefix;                   // of section ids, where a page shows several posteriors
  std::map<std::string, double> truth;  // by quantity, if the data were made with it [display unit]
  std::size_t most = 64;                // quantities shown: those learnt most about, and the eight
                                        // with the largest R-hat
};

[[nodiscard]] PosteriorPicture posterior_picture(const PosteriorRun& run,
                                                 const PictureOptions& options = {});

}  // namespace thenar
