#pragma once

/// Draws from the posterior: all parameters that priors and measured forces allow.
/// Example: examples/10_posterior.cpp, examples/14_fit_and_posterior.cpp.

#include <optional>
#include <string>
#include <vector>

#include "api/fit.h"
#include "api/predict.h"
#include "base/progress.h"
#include "base/provenance.h"
#include "posterior/run/posterior_summary.h"
#include "posterior/run/sample_posterior.h"

namespace thenar {

struct SampleRequest {
  FitSources sources;                             // data and model, as of a fit
  SamplingMethod method = SamplingMethod::kNuts;  // sampler
  unsigned seed = 1;                              // seed of the chains
  int chains = 4;                                 // independent chains, or ensembles [1]
  int walkers = 0;      // chains of one ensemble; 0: as the sampler needs [1]
  long warm_up = 1000;  // adaptation steps, which are discarded [1]
  long draws = 0;       // draws of each chain; 0: 1000 steps in all, which are doubled up to
                        // twice where more of them may make the chains agree [1]
  int thin = 0;         // steps a draw; 0: 1, of ensembles of many walkers 10 [1]
  double target_acceptance = 0.9;  // target of nuts and hmc; above the usual 0.8, as posteriors of
                                   // thumbs are strongly curved [1]
  std::vector<double> retry_acceptances{
      0.95, 0.99};     // restarts with the next target once a trajectory diverges; empty: none [1]
  int max_depth = 10;  // largest tree depth of nuts: at most 2^depth steps [1]
  int temperatures = 1;          // temperatures of parallel tempering; 1: none [1]
  double min_beta = 0;           // power of the likelihood on the hottest rung [1]
  int swap_every = 1;            // steps between swaps of temperatures [1]
  int mode_starts = 0;           // starts of the search for modes; 0: PosteriorSettings' own [1]
  bool fixed_noise = false;      // take the stated noise as known
  int threads = 0;               // 0: as many as there are processors
  double checkpoint_every = 10;  // time between checkpoints [s]
  bool fresh = false;            // discard an interrupted run of this output
  bool keep_unconverged =
      true;            // keep the state of chains that have not converged, for more draws later
  std::string output;  // posterior file (.nc); its chains are stored in OUTPUT.chains
  RunRecord run;       // record of the run for the file
};

/// Posterior with its summary and outcome.
struct PosteriorResult {
  SampleRequest request;                    // request; of an opened posterior, `output` alone
  Outcome outcome;                          // done: draws of each chain; stalled: not converged
  PosteriorRun run;                         // no draws: stopped before the first
  std::optional<PosteriorSummary> summary;  // absent without draws
  std::size_t rows = 20;                    // parameters listed in texts, the best known first
  FileDigests files = {};                   // digests of the inputs, or of the opened posterior
};

/// Samples, and writes the file. Under mpirun all ranks call it together; only the first writes. A
/// stopped run is continued by the same request, with the same final draws.
/// @returns no value on all ranks but the first
/// @throws InputError if another process is sampling there, or if the state of an interrupted run
/// is damaged or has other settings; and as the readers and samplers do.
[[nodiscard]] std::optional<PosteriorResult> sample_fit(const SampleRequest& request,
                                                        const Progress& progress = {});

/// Returns the posterior of a file. @throws InputError if it is no posterior; DataError if it is
/// damaged.
[[nodiscard]] PosteriorResult open_posterior(const std::string& path);

struct PosteriorPredictRequest {
  std::string posterior;                 // file of sample_fit() (.nc); required
  std::vector<std::string> experiments;  // files, or names of experiments/; at least one
  bool population = false;               // predict a fitted specimen as if it had never been seen
  long draws = 2000;                     // draws to predict with [1]
  std::string data;                      // folder with experiments/; empty: the usual ones
  std::optional<Path> path = {};         // tendon paths, see require_fit_path()
};

/// Predictions of posterior draws, with the posterior.
struct PosteriorPrediction {
  PosteriorPredictRequest request;  // request that was answered
  Outcome outcome;                  // stalled: the chains have not converged
  PredictResult predicted;          // means of the draws
  PosteriorResult posterior;        // posterior without a summary
};

/// Predicts every experiment by draws, and compares with the measurements.
/// @throws as predict_forces() does
[[nodiscard]] PosteriorPrediction predict_by_draws(const PosteriorPredictRequest& request);

}  // namespace thenar
