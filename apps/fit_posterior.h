#pragma once

/// `thenar fit --method mcmc`: draws instead of one best point.

#include <string>

#include <CLI/CLI.hpp>

#include "kinematics_fit/fit.h"
#include "posterior/run/sample_posterior.h"

namespace thenar {

/// What only a sampler asks of the command line.
struct ChainOptions {
  std::string sampler = "nuts";
  int chains = 4, walkers = 0, temperatures = 1, swap_every = 1, threads = 0;
  int mode_starts = 16, max_depth = 10;
  int thin = 0;                    // 0: 1, of ensembles of many walkers 10
  long warm_up = 1000, draws = 0;  // 0: 1000 steps in all
  double min_beta = 0, checkpoint_every_s = 10;
  double target_acceptance = 0.9;  // of nuts and hmc: thumbs bend more than textbook posteriors [1]
  bool fixed_noise = false, allow_unconverged = false, fresh = false;
};

void add_chain_options(CLI::App& command, ChainOptions& options);

/// Samples, writes `output` (ArviZ InferenceData), prints what was learnt. Under mpirun the first
/// rank alone writes, prints and fails; the others leave quietly.
/// @throws Error if the chains have not converged, unless allowed; the file is written first.
void fit_posterior(const FitInputs& inputs, const ChainOptions& options, unsigned seed,
                   const std::string& output, bool json);

}  // namespace thenar
