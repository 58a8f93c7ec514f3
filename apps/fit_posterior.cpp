#include "apps/fit_posterior.h"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/output_ending.h"
#include "apps/posterior_summary.h"
#include "apps/progress_bar.h"
#include "apps/read_source.h"
#include "base/error.h"
#include "posterior/run/posterior_file.h"

namespace thenar {
namespace {

PosteriorSettings settings_of(const ChainOptions& options, const FitInputs& inputs, unsigned seed,
                              const std::string& output) {
  PosteriorSettings settings;
  settings.posterior =
      posterior_options(parse_fit_settings(inputs.settings.text, inputs.settings.path).posterior);
  if (options.fixed_noise) settings.posterior.learn_noise = false;
  settings.mode_starts = options.mode_starts;
  RunOptions& run = settings.run;
  run.method = sampling_method(options.sampler);
  run.sampler.seed = seed;
  run.sampler.warm_up = options.warm_up;
  run.groups = options.chains;
  run.walkers = options.walkers;
  run.temperatures = options.temperatures;
  run.least_temper = options.least_temper;
  run.draws = options.draws;
  run.thin = options.thin;
  run.threads = options.threads;
  run.folder = output + ".chains";
  run.progress = terminal_progress();
  return settings;
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
  add("--warm-up", options.warm_up, "Steps that adapt and are thrown away")
      ->check(CLI::NonNegativeNumber);
  add("--draws", options.draws, "Draws of each chain")->check(CLI::PositiveNumber);
  add("--thin", options.thin, "Steps a draw")->check(CLI::PositiveNumber);
  add("--temperatures", options.temperatures, "Rungs of parallel tempering (1: none)")
      ->check(CLI::PositiveNumber);
  add("--least-temper", options.least_temper, "Power of the likelihood on the hottest rung")
      ->check(CLI::Range(0.0, 1.0));
  add("--mode-starts", options.mode_starts, "Starts of the search for modes")
      ->check(CLI::PositiveNumber);
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
  require_result_path(output);
  const std::unique_ptr<Ranks> ranks = world_ranks();
  const PosteriorSettings settings = settings_of(options, inputs, seed, output);
  if (options.fresh && ranks->rank() == 0) std::filesystem::remove_all(settings.run.folder);
  ranks->barrier();
  const PosteriorRun run = sample_posterior(inputs, settings, *ranks);
  if (ranks->rank() > 0) return;
  if (run.draws.draws() == 0)
    throw Interrupted(
        fmt::format("stopped before the first draw; '{}' holds the state: the same "
                    "command goes on",
                    settings.run.folder));
  write_posterior(run, output);
  if (json)
    fmt::print("{}\n", summary_json(run).dump(2));
  else
    print_summary(run);
  fmt::print(stderr, "wrote {}\n", output);
  if (!run.draws.complete)
    throw Interrupted(
        fmt::format("stopped; {} holds the draws so far, '{}' "
                    "the state: the same command goes on",
                    output, settings.run.folder));
  std::filesystem::remove_all(settings.run.folder);
  require_converged(run, options.allow_unconverged);
}

}  // namespace thenar
