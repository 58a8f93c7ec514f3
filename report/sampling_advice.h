#pragma once

/// Advice on the next options of `thenar fit --method mcmc`, if the sampler has not converged.

#include <string>
#include <utility>
#include <vector>

#include "posterior/run/sample_posterior.h"

namespace thenar {

/// One way out.
struct SamplingAdvice {
  std::string remedy;   // a sentence that names the cause and the options
  std::string command;  // the line to type; "" where the file does not say which command made it
};

/// Returns ways out of what is wrong with a run, the most promising first; none if nothing is. More
/// draws go on from where the chains stand; other settings need --fresh.
[[nodiscard]] std::vector<SamplingAdvice> advise(const PosteriorRun& run);

/// Returns the remedies one under the other, each with its command.
[[nodiscard]] std::string advice_text(const std::vector<SamplingAdvice>& advice);

/// Options with new values; an empty value takes the option away.
using OptionChanges = std::vector<std::pair<std::string, std::string>>;

/// Returns the arguments of a command with some options changed: "--draws 100" and "--draws=100"
/// alike. Options that take a value only; --fresh is added where asked for, and else taken away.
[[nodiscard]] std::vector<std::string> with_options(const std::vector<std::string>& arguments,
                                                    const OptionChanges& changes, bool fresh);

}  // namespace thenar
