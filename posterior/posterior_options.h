#pragma once

/// What a posterior learns beside the parameters of a digit, and with which priors.

#include "data/io/fit_settings.h"

namespace thenar {

/// Unknowns and priors of the posterior beyond those of the least-squares problem.
struct PosteriorOptions {
  bool learn_noise = true;           // a factor on every experiment's noise, with log-normal prior
  double noise_sd = 0.5;             // sd of its logarithm [1]
  bool learn_specimen_scale = true;  // with several specimens: a factor on between_sd of each kind
  double specimen_scale_sd = 0.5;    // sd of its logarithm [1]
  bool sphere_priors = true;         // von Mises-Fisher on axis directions instead of normal tilts
};

/// Options of a settings file; a sd of zero means that the factor is not learnt.
[[nodiscard]] PosteriorOptions posterior_options(const PosteriorPriors& beliefs);

}  // namespace thenar
