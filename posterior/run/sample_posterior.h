#pragma once

/// Sampling of a posterior from input files to draws: posterior, modes, chains, and their
/// convergence.

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

/// Options of the posterior in a settings file. @throws DataError if it cannot be read.
[[nodiscard]] PosteriorOptions posterior_options(const SourceText& settings);

/// Settings of a run of a posterior.
struct PosteriorSettings {
  PosteriorOptions posterior;
  RunOptions run;       // fingerprint and covariance are set by the run; walkers 0: as few as
                        // the method allows
  int mode_starts = 0;  // starts of the search for modes, before sampling; 0: 16, or 4 among more
                        // than 1000 coordinates, which the run's settings then say [1]
  std::vector<double>
      retry_acceptances;  // target acceptances of retry_divergent(); empty: none [1]
  ConvergenceLimits limits;
  long max_draws = 0;  // of each chain, to which run.draws is doubled while more draws may help;
                       // run must have a folder to go on from. Below run.draws: never [1]
};

/// Draws from the posterior of a digit.
struct PosteriorRun {
  FitInputs inputs;
  PosteriorSettings settings;     // with the target acceptance of the attempt that made the draws,
                                  // and their number
  std::vector<double> abandoned;  // target acceptances of attempts that ended at a divergence [1]
  std::shared_ptr<const HandPosterior> posterior;  // shared by copies of the run
  std::vector<Mode> modes;                         // found before sampling, best first
  Draws draws;
  Convergence convergence;
  ModeTable mode_table;  // masses of the modes, from the draws
  RunRecord run;         // of the command that sampled it; empty in a program, and in older files
};

/// Finds the modes, starts chains at overdispersed points about them, samples, and assesses the
/// draws.
///
/// A stop request during the search returns no draws and no modes: the next call searches again.
/// With several ranks, the first alone searches and returns all results; the others return no
/// draws.
/// @throws InputError or DataError as build_problem() and run_chains() do, and if no start of
/// finite density is found; on all ranks alike.
[[nodiscard]] PosteriorRun sample_posterior(const FitInputs& inputs,
                                            const PosteriorSettings& settings,
                                            const Communicator& ranks);
[[nodiscard]] PosteriorRun sample_posterior(const FitInputs& inputs,
                                            const PosteriorSettings& settings);

/// Sentence about the run: "nuts: 4 chains of 1000 draws after 1000 steps of warm-up, 3.2 s".
[[nodiscard]] std::string describe_run(const PosteriorRun& run);

/// All draws of all chains side by side, chain by chain (size, chains * draws).
[[nodiscard]] Eigen::MatrixXd pooled(const Draws& draws);

/// Returns at most `most` columns, evenly spread over all: of pooled() chains as many draws of
/// each, if `most` is a multiple of their number (size, columns).
[[nodiscard]] Eigen::MatrixXd thinned(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                      Eigen::Index most);

/// Assesses the draws of a run and assigns them to its modes: fills `convergence` and `mode_table`.
/// The answers that settle coordinates (settled_by_answers()) are the forces of all fitted trials,
/// of each specimen and, where there are several, of a new one. Does nothing without draws.
void assess_run(PosteriorRun& run);

}  // namespace thenar
