// thenar fit EXPERIMENT... --subject SUBJECT -o FIT.h5
//
// Fits the parameters of a digit to measured fingertip forces. Several specimens are fitted
// together, as people who differ from their population. With --method mcmc the whole posterior is
// sampled instead: under mpirun by all ranks, and an interrupted run goes on where it stopped.

#include <algorithm>
#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "api/fit.h"
#include "api/posterior.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/nearest_name.h"
#include "base/progress_parts.h"
#include "report/answers/fit.h"
#include "report/answers/posterior.h"
#include "report/pages/fit.h"
#include "report/pages/posterior.h"

namespace thenar {
namespace {

constexpr const char* kSampling = "mcmc";

struct FitArguments {
  std::string method = "ceres", sampler = "nuts";
  std::vector<std::string> leave_out;
  FitRequest fit;
  SampleRequest chains;
  bool allow_unconverged = false, no_retry = false;
  Outputs outputs;
};

void require_method(const std::string& method) {
  const std::vector<std::string> known{"ceres", "nlopt", "nlopt-global", "ipopt", kSampling};
  require(std::find(known.begin(), known.end(), method) != known.end(),
          "no fit method '{}'{}; there are {}", method, did_you_mean(method, known), listed(known));
}

/// Requires endings of files that the kind of result can have; other endings, such as that of a
/// page, are checked elsewhere.
void require_endings(const Outputs& outputs, bool sampling) {
  const std::vector<std::string> others = outputs.with_ending(
      sampling ? std::vector<std::string>{".h5", ".toml"} : std::vector<std::string>{".nc"});
  require(others.empty(), "wanted an output that ends in {}, got '{}'",
          sampling ? ".nc" : ".h5 or .toml", others.empty() ? "" : others.front());
}

void fit_best(FitArguments& options) {
  FitRequest& request = options.fit;
  request.method = least_squares_method(options.method);
  request.leave_out.clear();
  for (const std::string& name : options.leave_out)
    request.leave_out.push_back(leave_out_named(name));
  request.output = options.outputs.one(".h5");
  request.run = this_run();
  const FitResult result = fit_digit(request, terminal_progress());
  for (const std::string& file : options.outputs.with_ending({".toml"}))
    write_file(file, result.fit.inputs.settings.text);
  print_warnings(result.outcome.warnings);
  deliver(options.outputs, result);
  require(!result.fit.solution.failed, "the fit failed: {}; the file holds the best point found",
          result.fit.solution.message);
  if (result.outcome.stopped()) throw Stopped("stopped; the file holds the best point so far");
  const std::string complaint = fit_complaint(result, options.allow_unconverged);
  if (complaint.empty()) return;
  if (!options.allow_unconverged) throw Error(complaint);
  print_warnings({complaint});
}

/// Checks that all requested draws were made. @throws Stopped otherwise
void require_complete(const PosteriorResult& result) {
  const PosteriorRun& run = result.run;
  if (run.modes.empty()) throw Stopped("stopped in the search for modes; nothing was written");
  const std::string& folder = run.settings.run.folder;
  if (run.draws.draws() == 0)
    throw Stopped(fmt::format(
        "stopped before the first draw; '{}' holds the state: the same command goes on", folder));
  if (result.outcome.stopped())
    throw Stopped(fmt::format(
        "stopped; '{}' holds the {} draws so far, '{}' the state: the same command goes on",
        result.request.output, result.outcome.done, folder));
}

void sample_posterior_of(FitArguments& options) {
  require(!options.fit.choose_settings,
          "--choose-settings is for fits; sample with the settings that a fit has chosen");
  require(options.leave_out.empty(),
          "--cross-validate is for fits; a posterior's file says how well it would predict each "
          "trial unseen (`thenar posterior summary`)");
  SampleRequest& request = options.chains;
  request.sources = options.fit.sources;
  request.method = sampling_method(options.sampler);
  request.seed = options.fit.seed;
  request.keep_unconverged = !options.allow_unconverged;
  if (options.no_retry) request.retry_acceptances.clear();
  request.output = options.outputs.one(".nc");
  require(!request.output.empty(), "--method mcmc needs a file for its draws: -o P.nc");
  request.run = this_run();
  const std::optional<PosteriorResult> result = sample_fit(request, terminal_progress());
  if (!result) return;  // another rank answers
  if (result->run.draws.draws() > 0) deliver(options.outputs, *result);
  std::fflush(stdout);
  require_complete(*result);
  print_warnings(result->outcome.warnings);
  print_warnings(noise_cautions(*result));
  print_warnings(convergence_cautions(result->run));
  const std::string complaint = convergence_complaint(result->run, options.allow_unconverged);
  if (complaint.empty()) return;
  if (!options.allow_unconverged) throw Error(complaint);
  print_warnings({complaint});
}

void run_fit(FitArguments& options) {
  require_method(options.method);
  const bool sampling = options.method == kSampling;
  require_endings(options.outputs, sampling);
  if (sampling)
    sample_posterior_of(options);
  else
    fit_best(options);
}

void add_chain_options(CLI::App& command, FitArguments& options) {
  const std::string group = "With --method mcmc";
  SampleRequest& chains = options.chains;
  const auto add = [&](const char* name, auto& value, const char* text) {
    return command.add_option(name, value, text)->group(group);
  };
  add("--sampler", options.sampler, "nuts|hmc|adaptive-metropolis|dream-zs|stretch");
  add("--chains", chains.chains, "Independent chains, or ensembles")->check(CLI::PositiveNumber);
  add("--walkers", chains.walkers, "Chains of one ensemble (0: as the sampler needs)")
      ->check(CLI::NonNegativeNumber);
  add("--target-acceptance", chains.target_acceptance,
      "Of nuts and hmc: higher takes smaller steps, against divergent ones")
      ->check(CLI::Range(0.05, 0.999));
  add("--max-depth", chains.max_depth, "Of trees of nuts: 2^depth steps at most")
      ->check(CLI::Range(1, 30));
  add("--warm-up", chains.warm_up, "Steps that adapt and are thrown away")
      ->check(CLI::NonNegativeNumber);
  add("--draws", chains.draws,
      "Draws of each chain (1000, of stretch 100; doubled up to twice where the chains do "
      "not agree yet and more may help)")
      ->check(CLI::PositiveNumber)
      ->default_str("");
  add("--thin", chains.thin, "Steps a draw (1, of stretch 10)")
      ->check(CLI::PositiveNumber)
      ->default_str("");
  add("--temperatures", chains.temperatures, "Rungs of parallel tempering (1: none)")
      ->check(CLI::PositiveNumber);
  add("--least-temper", chains.min_beta, "Power of the likelihood on the hottest rung")
      ->check(CLI::Range(0.0, 1.0));
  add("--swap-every", chains.swap_every, "Steps between swaps of temperatures")
      ->check(CLI::PositiveNumber);
  add("--mode-starts", chains.mode_starts,
      "Starts of the search for modes (0: 16, or 4 among more than 1000 coordinates)")
      ->check(CLI::NonNegativeNumber);
  add("--checkpoint-every-s", chains.checkpoint_every,
      "Seconds between checkpoints: what a kill may cost")
      ->check(CLI::NonNegativeNumber);
  add("--threads", chains.threads, "0: as many as there are processors")
      ->check(CLI::NonNegativeNumber);
  const auto flag = [&](const char* name, bool& value, const char* text) {
    command.add_flag(name, value, text)->group(group);
  };
  flag("--fixed-noise", chains.fixed_noise, "Believe the stated noise");
  flag("--no-retry", options.no_retry,
       "Keep chains whose trajectories diverge, rather than begin anew with smaller steps (at "
       "target acceptances of 0.95 and 0.99)");
  flag("--fresh", chains.fresh, "Forget an interrupted run of this output");
}

}  // namespace

void add_fit(CLI::App& app) {
  auto options = std::make_shared<FitArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("fit", "Fit a digit to measured fingertip forces");
  FitSources& sources = options->fit.sources;
  command->add_option("experiments", sources.experiments, "Experiments: names, or files (TOML)")
      ->required()
      ->default_str("");
  command
      ->add_option("--subject", sources.subject,
                   "Subject to start from: its name, or its file (TOML)")
      ->required();
  command->add_option(
      "--method", options->method,
      "ceres, ipopt: by derivatives; nlopt, nlopt-global: without; mcmc: draws from "
      "the posterior instead of one best point");
  command->add_option("--settings", sources.settings,
                      "Which parameters move: name or file (built in for the digit if left out; "
                      "`thenar explain SUBJECT` lists them)");
  command
      ->add_option("--net", sources.net,
                   "Extensor net in place of the subject's hood: name or file (none). With "
                   "--cross-validate the same fit with the hood's fractions stands beside it")
      ->default_str("");
  command
      ->add_option("--free", sources.also_free,
                   "Also free the parameters matching these globs (none)")
      ->default_str("");
  command
      ->add_option("--cross-validate", options->leave_out,
                   "Also leave out one posture|tendon|specimen at a time (nothing)")
      ->default_str("");
  command->add_option("--scale", sources.scale,
                      "Size of the digit before parameters act: the subject's own, or by what "
                      "each experiment states in [outside]: subject|outside");
  command->add_flag("--choose-settings", options->fit.choose_settings,
                    "Choose among the [[choose]] rows of the settings by left-out postures and "
                    "specimens; --cross-validate then chooses in every fold anew. -o FILE.toml "
                    "keeps what was chosen");
  command->add_option("--seed", options->fit.seed, "Of the global search, or of the chains");
  command
      ->add_option("--max-evaluations", options->fit.max_evaluations, "0: the method's own limit")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--allow-unconverged", options->allow_unconverged,
                    "Exit without error though the fit or the chains have not converged");
  add_fit_path_option(*command, sources.path);
  add_data_option(*command, sources.data);
  add_output_options(*command, options->outputs, {true, true, true, {".h5", ".nc", ".toml"}});
  add_chain_options(*command, *options);
  add_examples(
      *command,
      {"fit synek2019_H01 synek2019_H02 --subject an_chao_middle -o out/fit.h5 --report "
       "out/fit.html",
       "fit synek2019_H01 --subject synek2019_middle --cross-validate posture -o out/fit.html",
       "fit synek2019_H01 synek2019_H02 --subject an_chao_middle --net winslow -o out/fit.html",
       "fit synek2019_H01 synek2019_H02 --subject an_chao_middle --choose-settings "
       "--cross-validate specimen -o out/settings.toml --report out/fit.html",
       "fit synek2019_H01 --subject synek2019_middle --method mcmc -o out/P.nc"});
  command->callback([options] { run_fit(*options); });
}

}  // namespace thenar
