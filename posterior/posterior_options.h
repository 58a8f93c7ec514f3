#pragma once

/// Unknowns that a posterior infers besides the parameters of a digit, and their priors.

#include "data/io/fit_settings.h"

namespace thenar {

/// Unknowns and priors of the posterior beyond those of the least-squares problem.
struct PosteriorOptions {
  bool learn_noise = true;  // infer a factor on every experiment's noise, with a log-normal prior
  double noise_sd = 0.5;    // prior sd of the factor's logarithm [1]
  bool learn_specimen_scale =
      true;  // infer a factor on between_sd of each kind if there are several specimens
  double specimen_scale_sd = 0.5;  // prior sd of the factor's logarithm [1]
  bool sphere_priors = true;  // von Mises-Fisher priors of axis directions instead of normal tilts
};

/// Returns the options of a settings file; an sd of zero disables the factor.
[[nodiscard]] PosteriorOptions posterior_options(const PosteriorPriors& beliefs);

}  // namespace thenar
