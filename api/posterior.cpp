#include "api/posterior.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "api/named/files.h"
#include "base/error.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/posterior_file.h"
#include "posterior/run/predict_draws.h"
#include "sampling/run/communicator.h"
#include "sampling/run/durable_file.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

PosteriorSettings settings_of(const SampleRequest& request, const FitInputs& inputs,
                              const Progress& progress) {
  PosteriorSettings settings;
  settings.posterior = posterior_options(inputs.settings);
  if (request.fixed_noise) settings.posterior.learn_noise = false;
  // Settings of the sampler, as the request states them.
  settings.mode_starts = request.mode_starts;
  RunOptions& run = settings.run;
  run.method = request.method;
  run.sampler.seed = request.seed;
  run.sampler.warm_up = request.warm_up;
  run.sampler.max_depth = request.max_depth;
  if (is_hamiltonian(run.method)) run.sampler.target_acceptance = request.target_acceptance;
  settings.retry_acceptances = request.retry_acceptances;
  // Groups are chains, or ensembles of walkers.
  run.groups = request.chains;
  run.walkers = request.walkers;
  run.temperatures = request.temperatures;
  run.min_beta = request.min_beta;
  run.swap_every = request.swap_every;
  // An ensemble has more than twice as many walkers as parameters, all of which draw.
  const int sparse = run.method == SamplingMethod::kStretchMove ? 10 : 1;
  run.thin = request.thin > 0 ? request.thin : sparse;
  run.draws = request.draws > 0 ? request.draws : 1000 / sparse;
  constexpr long kMaxGrowth = 4;  // most draws over the first ones, where nobody says how many [1]
  if (request.draws == 0) settings.max_draws = kMaxGrowth * run.draws;
  // Store checkpoints beside the result, so that a killed run can be continued.
  run.threads = request.threads;
  run.folder = request.output + ".chains";
  run.checkpoint_every = request.checkpoint_every;
  run.progress = progress;
  return settings;
}

/// Deletes a run with all its attempts, states first, so that a run killed in between restarts.
/// @throws InputError if another process is sampling there.
void forget_run(const std::string& folder) {
  std::error_code none;
  if (!fs::exists(folder, none)) return;
  // Whoever samples holds the lock of one attempt.
  std::vector<std::string> attempts{folder};
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) attempts.push_back(entry.path().string());
  std::vector<internal::AppendFile> locks;
  for (const std::string& attempt : attempts) {
    locks.emplace_back(attempt + "/lock");
    require(locks.back().lock(), "another process is sampling in '{}'", attempt);
  }
  for (const std::string& attempt : attempts) fs::remove(attempt + "/state.bin");
  fs::remove_all(folder);
}

PosteriorRun sample(const FitInputs& inputs, const PosteriorSettings& settings,
                    const Communicator& ranks) try {
  return sample_posterior(inputs, settings, ranks);
} catch (const CheckpointError& refusal) {
  const bool damaged = refusal.kind() == CheckpointError::Kind::kDamaged;
  throw InputError(fmt::format("{}\n{} a fresh one forgets it and starts over.", refusal.what(),
                               damaged ? "No run can go on with it:"
                                       : "The one that began it can go on with it;"),
                   "fresh");
}

/// Writes the draws, on the first rank, and removes the saved state of a finished run.
void keep(const PosteriorResult& result) {
  const PosteriorRun& run = result.run;
  if (run.draws.draws() == 0) return;
  write_posterior(run, result.request.output);
  // Keep the state of chains that have not converged, for more draws later.
  if (run.draws.complete && (run.convergence.warnings.empty() || !result.request.keep_unconverged))
    forget_run(run.settings.run.folder);
}

/// Returns a result without warnings, files and summary.
PosteriorResult result_of(const SampleRequest& request, PosteriorRun run) {
  Outcome outcome;
  if (!run.convergence.warnings.empty()) outcome.status = Status::kStalled;
  if (!run.draws.complete) outcome.status = Status::kStopped;
  outcome.done = static_cast<std::size_t>(run.draws.draws());
  outcome.asked = static_cast<std::size_t>(run.settings.run.draws);
  outcome.part = "draw";
  return {request, std::move(outcome), std::move(run), {}};
}

PosteriorResult opened(const std::string& path) {
  SampleRequest request;
  request.output = path;
  return result_of(request, read_posterior(path));
}

/// Draws samples on all ranks together; an exception on one rank is thrown on all of them.
PosteriorResult sample_together(const SampleRequest& request, const Progress& progress,
                                const Communicator& ranks) {
  // Every rank reads its own inputs; the first alone reports and writes.
  FitInputs inputs;
  PosteriorSettings settings;
  collective_call(ranks, [&] {
    inputs = read_fit_inputs(request.sources);
    settings = settings_of(request, inputs, progress);
    if (ranks.rank() > 0) settings.run.progress.report = nullptr;
    if (ranks.rank() == 0) require_result_path(request.output);
    if (ranks.rank() == 0 && request.fresh) forget_run(settings.run.folder);
  });
  // Sample together, then keep the result on the first rank.
  PosteriorResult result = result_of(request, sample(inputs, settings, ranks));
  result.files = source_digests(sources_of(inputs));
  result.outcome.warn(path_cautions(inputs));
  result.run.run = request.run;
  collective_call(ranks, [&] {
    if (ranks.rank() == 0) keep(result);
  });
  return result;
}

}  // namespace

std::optional<PosteriorResult> sample_fit(const SampleRequest& request, const Progress& progress) {
  std::optional<PosteriorResult> result = result_of_first_rank(
      [&](const Communicator& ranks) { return sample_together(request, progress, ranks); });
  if (result && result->run.draws.draws() > 1) result->summary = summarise_posterior(result->run);
  return result;
}

PosteriorResult open_posterior(const std::string& path) {
  require_kind(path, {"posterior"});
  PosteriorResult result = opened(path);
  result.outcome.warn(checksum_warnings(path));
  result.files = digests_of({path});
  result.outcome.warn(path_cautions(result.run.inputs));
  result.summary = summarise_posterior(result.run);
  return result;
}

PosteriorPrediction predict_by_draws(const PosteriorPredictRequest& request) {
  require_field("experiments", !request.experiments.empty(),
                "wanted at least one experiment to predict");
  require_fit_path(request.path);
  in_field("posterior", [&] { require_kind(request.posterior, {"posterior"}); });
  PosteriorPrediction out{request, {}, {}, opened(request.posterior)};
  const PosteriorRun& run = out.posterior.run;
  const FitProblem& problem = run.posterior->problem();
  PredictResult& result = out.predicted;
  result.request = {request.posterior, request.experiments, request.population, request.data,
                    request.path};
  // Describe the predicting fit and its data.
  result.inputs = run.inputs;
  result.fitted_by = run.run;
  result.fidelity = problem.digit().fidelity;
  result.outcome.warn(checksum_warnings(request.posterior));
  result.outcome.warn(path_cautions(run.inputs));
  const long kept = run.draws.chains() * run.draws.draws();
  if (kept < request.draws)
    result.outcome.warnings.push_back(fmt::format(
        "the posterior has {} draws, fewer than the {} that were asked for: all of them predict",
        kept, request.draws));
  const auto predict = [&](const Experiment& experiment, int specimen) {
    return summarise(predict_draws(run, experiment, specimen, request.draws));
  };
  add_predictions(problem, predict, result);
  out.outcome = result.outcome;
  // Chains that do not agree make the answer doubtful, but not useless.
  if (!run.convergence.warnings.empty()) out.outcome.status = Status::kStalled;
  return out;
}

}  // namespace thenar
