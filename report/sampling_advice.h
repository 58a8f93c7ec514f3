#pragma once

/// Advice on the next options of `thenar fit --method mcmc`, if the sampler has not converged.

#include <string>
#include <utility>
#include <vector>

#include "posterior/run/sample_posterior.h"

namespace thenar {

/// One remedy.
struct SamplingAdvice {
  std::string remedy;   // sentence that names the cause and the options
  std::string command;  // command line; "" if the file does not record its command
};

/// Returns remedies for the problems of a run, the most promising first; none without problems.
/// More draws continue the chains; other settings need --fresh.
[[nodiscard]] std::vector<SamplingAdvice> advise(const PosteriorRun& run);

/// Returns a text with all remedies, each with its command.
[[nodiscard]] std::string advice_text(const std::vector<SamplingAdvice>& advice);

/// Options with new values; an empty value removes the option.
using OptionChanges = std::vector<std::pair<std::string, std::string>>;

/// Returns the arguments of a command with some options changed: "--draws 100" and "--draws=100"
/// alike. Only for options with a value; --fresh is added if requested, else removed.
[[nodiscard]] std::vector<std::string> with_options(const std::vector<std::string>& arguments,
                                                    const OptionChanges& changes, bool fresh);

}  // namespace thenar
