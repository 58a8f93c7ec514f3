#include "apps/fit_posterior.h"

#include <cstdio>
#include <exception>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "api/files.h"
#include "apps/options.h"
#include "apps/posterior_summary.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/progress_parts.h"
#include "posterior/run/posterior_file.h"
#include "report/json.h"
#include "sampling/run/communicator.h"
#include "sampling/run/durable_file.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

PosteriorSettings settings_of(const ChainOptions& options, const FitInputs& inputs, unsigned seed,
                              const std::string& output) {
  PosteriorSettings settings;
  settings.posterior = posterior_options(inputs.settings);
  if (options.fixed_noise) settings.posterior.learn_noise = false;
  settings.mode_starts = options.mode_starts;
  RunOptions& run = settings.run;
  run.method = sampling_method(options.sampler);
  run.sampler.seed = seed;
  run.sampler.warm_up = options.warm_up;
  run.sampler.max_depth = options.max_depth;
  if (run.method == SamplingMethod::kNuts || run.method == SamplingMethod::kHmc)
    run.sampler.target_acceptance = options.target_acceptance;
  run.groups = options.chains;
  run.walkers = options.walkers;
  run.temperatures = options.temperatures;
  run.min_beta = options.min_beta;
  run.swap_every = options.swap_every;
  // An ensemble has more than twice as many walkers as parameters, all of which draw.
  const int sparse = run.method == SamplingMethod::kStretchMove ? 10 : 1;
  run.thin = options.thin > 0 ? options.thin : sparse;
  run.draws = options.draws > 0 ? options.draws : 1000 / sparse;
  run.threads = options.threads;
  run.folder = output + ".chains";
  run.checkpoint_every = options.checkpoint_every_s;
  run.progress = terminal_progress();
  return settings;
}

/// Forgets a run. Its state goes first: what is left if we are killed here begins anew.
/// @throws InputError if another process is sampling there.
void forget_run(const std::string& folder) {
  std::error_code none;
  if (!fs::exists(folder, none)) return;
  internal::AppendFile lock(folder + "/lock");
  require(lock.lock(), "another process is sampling in '{}'", folder);
  fs::remove(folder + "/state.bin");
  fs::remove_all(folder);
}

PosteriorRun sample(const FitInputs& inputs, const PosteriorSettings& settings,
                    const Communicator& ranks) try {
  return sample_posterior(inputs, settings, ranks);
} catch (const CheckpointError& refusal) {
  const bool damaged = refusal.kind() == CheckpointError::Kind::kDamaged;
  throw InputError(fmt::format(
      "{}\n{} --fresh forgets it and begins anew.", refusal.what(),
      damaged ? "No command can go on with it." : "The command that began it can go on with it;"));
}

/// Of the first rank: the file, and what was learnt.
void tell(const PosteriorRun& run, const ChainOptions& options, const std::string& output,
          bool json) {
  const std::string& folder = run.settings.run.folder;
  if (run.modes.empty()) throw Stopped("stopped in the search for modes; nothing was written");
  if (run.draws.draws() == 0)
    throw Stopped(fmt::format(
        "stopped before the first draw; '{}' holds the state: the same command goes on", folder));
  write_posterior(run, output);
  if (json)
    fmt::print("{}\n", json_text(summary_json(run)));
  else
    print_summary(run);
  std::fflush(stdout);
  fmt::print(stderr, "wrote {}\n", output);
  if (!run.draws.complete)
    throw Stopped(fmt::format(
        "stopped; '{}' holds the {} draws so far, '{}' the state: the same command goes on", output,
        run.draws.draws(), folder));
  // Chains that have not converged may be asked for more draws.
  if (run.convergence.warnings.empty() || options.allow_unconverged) forget_run(folder);
  require_converged(run, options.allow_unconverged);
}

/// All that ranks do together; whatever it throws, it throws on all of them.
void fit_together(const FitInputs& inputs, const ChainOptions& options, unsigned seed,
                  const std::string& output, bool json, const Communicator& ranks) {
  PosteriorSettings settings;
  collective_call(ranks, [&] {
    settings = settings_of(options, inputs, seed, output);
    if (ranks.rank() > 0) settings.run.progress.report = nullptr;
    if (ranks.rank() == 0) require_result_path(output);
    if (ranks.rank() == 0 && options.fresh) forget_run(settings.run.folder);
  });
  const PosteriorRun run = sample(inputs, settings, ranks);
  collective_call(ranks, [&] {
    if (ranks.rank() == 0) tell(run, options, output, json);
  });
}

}  // namespace

void add_chain_options(CLI::App& command, ChainOptions& options) {
  const std::string group = "With --method mcmc";
  const auto add = [&](const char* name, auto& value, const char* text) {
    return command.add_option(name, value, text)->group(group);
  };
  add("--sampler", options.sampler, "nuts|hmc|adaptive-metropolis|dream-zs|stretch");
  add("--chains", options.chains, "Independent chains, or ensembles")->check(CLI::PositiveNumber);
  add("--walkers", options.walkers, "Chains of one ensemble (0: as the sampler needs)")
      ->check(CLI::NonNegativeNumber);
  add("--target-acceptance", options.target_acceptance,
      "Of nuts and hmc: higher takes smaller steps, against divergent ones")
      ->check(CLI::Range(0.05, 0.999));
  add("--max-depth", options.max_depth, "Of trees of nuts: 2^depth steps at most")
      ->check(CLI::Range(1, 30));
  add("--warm-up", options.warm_up, "Steps that adapt and are thrown away")
      ->check(CLI::NonNegativeNumber);
  add("--draws", options.draws, "Draws of each chain (default 1000, stretch 100)")
      ->check(CLI::PositiveNumber);
  add("--thin", options.thin, "Steps a draw (default 1, stretch 10)")->check(CLI::PositiveNumber);
  add("--temperatures", options.temperatures, "Rungs of parallel tempering (1: none)")
      ->check(CLI::PositiveNumber);
  add("--least-temper", options.min_beta, "Power of the likelihood on the hottest rung")
      ->check(CLI::Range(0.0, 1.0));
  add("--swap-every", options.swap_every, "Steps between swaps of temperatures")
      ->check(CLI::PositiveNumber);
  add("--mode-starts", options.mode_starts, "Starts of the search for modes")
      ->check(CLI::PositiveNumber);
  add("--checkpoint-every-s", options.checkpoint_every_s,
      "Seconds between checkpoints: what a kill may cost")
      ->check(CLI::NonNegativeNumber);
  add("--threads", options.threads, "0: as many as there are processors")
      ->check(CLI::NonNegativeNumber);
  command.add_flag("--fixed-noise", options.fixed_noise, "Believe the stated noise")->group(group);
  command
      .add_flag("--allow-unconverged", options.allow_unconverged,
                "Do not fail if the chains have not converged")
      ->group(group);
  command.add_flag("--fresh", options.fresh, "Forget an interrupted run of this output")
      ->group(group);
}

void fit_posterior(const FitInputs& inputs, const ChainOptions& options, unsigned seed,
                   const std::string& output, bool json) {
  require_ending(output, {".nc"});
  std::exception_ptr warning;
  {
    const std::unique_ptr<Communicator> ranks = world_communicator();
    try {
      fit_together(inputs, options, seed, output, json, *ranks);
    } catch (const std::exception&) {
      if (ranks->rank() == 0) warning = std::current_exception();
    }
  }  // MPI ends in peace before the first rank fails alone
  if (warning) std::rethrow_exception(warning);
}

}  // namespace thenar
