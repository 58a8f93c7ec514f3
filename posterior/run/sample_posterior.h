#pragma once

/// Sampling of a posterior from input files to draws: posterior, modes, chains, and convergence.

#include <memory>
#include <string>
#include <vector>

#include "base/run_record.h"
#include "kinematics_fit/fit.h"
#include "posterior/find_modes.h"
#include "posterior/posterior_options.h"
#include "sampling/diagnostics/convergence.h"
#include "sampling/diagnostics/modes.h"
#include "sampling/run/retry_divergent.h"
#include "sampling/run/run_chains.h"

namespace thenar {

class HandPosterior;

/// Returns the options of the posterior in a settings file. @throws DataError if it cannot be read.
[[nodiscard]] PosteriorOptions posterior_options(const SourceText& settings);

/// Settings of a posterior run.
struct PosteriorSettings {
  PosteriorOptions posterior;
  RunOptions run;  // settings of the chains; fingerprint and covariance are set by the run; walkers
                   // 0: the minimum of the method
  int mode_starts = 0;  // number of starts of the mode search; 0: 16, or 4 if there are more than
                        // 1000 coordinates; the run's settings state the number used [1]
  std::vector<double>
      retry_acceptances;  // target acceptances of retry_divergent(); empty: none [1]
  ConvergenceLimits limits;
  long max_draws = 0;  // limit of each chain up to which run.draws is doubled while more draws may
                       // help; requires a run folder. Below run.draws: never doubled [1]
};

/// Draws from the posterior of a digit.
struct PosteriorRun {
  FitInputs inputs;
  PosteriorSettings settings;  // settings, with the target acceptance of the attempt that produced
                               // the draws, and their number
  std::vector<double> abandoned;  // target acceptances of attempts that ended at a divergence [1]
  std::shared_ptr<const HandPosterior> posterior;  // posterior, shared by copies of the run
  std::vector<Mode> modes;                         // modes found before sampling, best first
  Draws draws;
  Convergence convergence;
  ModeTable mode_table;  // masses of the modes, from the draws
  RunRecord run;  // record of the command that sampled; empty for library calls and in older files
};

/// Finds the modes, starts chains at overdispersed points around them, samples, and assesses the
/// draws.
///
/// A stop request during the mode search returns no draws and no modes: the next call searches
/// again. With several ranks, only the first searches and returns results; the others return no
/// draws.
/// @throws InputError or DataError as build_problem() and run_chains() do, or if no start has
///         finite
/// density; on all ranks alike.
[[nodiscard]] PosteriorRun sample_posterior(const FitInputs& inputs,
                                            const PosteriorSettings& settings,
                                            const Communicator& ranks);
[[nodiscard]] PosteriorRun sample_posterior(const FitInputs& inputs,
                                            const PosteriorSettings& settings);

/// Describes the run: "nuts: 4 chains of 1000 draws after 1000 steps of warm-up, 3.2 s".
[[nodiscard]] std::string describe_run(const PosteriorRun& run);

/// Returns all draws of all chains side by side, chain by chain (size, chains * draws).
[[nodiscard]] Eigen::MatrixXd pooled(const Draws& draws);

/// Returns at most `max_count` evenly spaced columns (size, columns). For pooled() draws, each
/// chain contributes equally if `max_count` is a multiple of the number of chains.
[[nodiscard]] Eigen::MatrixXd thinned(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                      Eigen::Index max_count);

/// Assesses the draws of a run and assigns them to its modes: sets `convergence` and `mode_table`.
/// The answers used by settled_by_answers() are the forces of all fitted trials, of each specimen
/// and, if there are several, of a new one. Does nothing without draws.
void assess_run(PosteriorRun& run);

}  // namespace thenar
