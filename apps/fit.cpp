// thenar fit EXPERIMENT... --subject SUBJECT -o FIT.h5
//
// Fits the parameters of a digit to measured fingertip forces. Several specimens are fitted
// together, as people who differ from their population. With --method mcmc the whole posterior is
// sampled instead: under mpirun by all ranks, and an interrupted run is continued.

#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "api/fit.h"
#include "api/posterior.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/request_options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"
#include "base/progress_parts.h"
#include "questions/question_params.h"
#include "report/answers/fit.h"
#include "report/answers/posterior.h"
#include "report/pages/fit.h"
#include "report/pages/posterior.h"

namespace thenar {
namespace {

constexpr const char* kSampling = "mcmc";

struct FitArguments {
  std::string method = "ceres";
  Json fit = Json::object(), chains = Json::object();  // typed arguments
  bool allow_unconverged = false, no_retry = false;
  Outputs outputs;
};

void require_method(const std::string& method) {
  const std::vector<std::string> known{"ceres", "nlopt", "nlopt-global", "ipopt", kSampling};
  require(contains(known, method), "no fit method '{}'{} there are {}", method,
          hint_before_list(method, known), listed(known));
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
  options.fit["method"] = options.method;
  FitRequest request = record_typed("fit", fit_params(), options.fit);
  request.output = options.outputs.only_file(".h5");
  request.run = this_run();
  const FitResult result = fit_digit(request, terminal_progress());
  // Settings that data chose are a file of their own, to fit again with.
  for (const std::string& file : options.outputs.with_ending({".toml"}))
    write_file(file, result.fit.inputs.settings.text);
  print_warnings(result.outcome.warnings);
  deliver(options.outputs, result);
  // Write the best point even if the fit failed, then end with an error.
  require(!result.fit.solution.failed, "the fit failed: {}; the file holds the best point found",
          result.fit.solution.message);
  if (result.outcome.stopped()) throw Stopped("stopped; the file holds the best point so far");
  complain(refusal_of(result), options.allow_unconverged);
}

/// Checks that all requested draws were made. @throws Stopped otherwise
void require_complete(const PosteriorResult& result) {
  const PosteriorRun& run = result.run;
  if (run.modes.empty()) throw Stopped("stopped in the search for modes; nothing was written");
  const std::string& folder = run.settings.run.folder;
  if (run.draws.draws() == 0)
    throw Stopped(fmt::format(
        "stopped before the first draw; '{}' holds the state: the same command continues", folder));
  if (result.outcome.stopped())
    throw Stopped(fmt::format(
        "stopped; '{}' holds the {} draws so far, '{}' the state: the same command continues",
        result.request.output, result.outcome.done, folder));
}

void sample_posterior_of(FitArguments& options) {
  // Refuse what only a single best point can answer.
  require(!options.fit.contains("choose_settings"),
          "--choose-settings is for fits; sample with the settings that a fit has chosen");
  require(!options.fit.contains("leave_out"),
          "--cross-validate is for fits; a posterior's file says how well it would predict each "
          "trial unseen (`thenar posterior summary`)");
  // Options that fits and posteriors share are typed once.
  options.fit.erase("max_evaluations");
  options.chains.update(options.fit);
  SampleRequest request = record_typed("posterior", posterior_params(), options.chains);
  request.keep_unconverged = !options.allow_unconverged;
  if (options.no_retry) request.retry_acceptances.clear();
  request.output = options.outputs.only_file(".nc");
  require(!request.output.empty(), "--method mcmc needs a file for its draws: -o P.nc");
  request.run = this_run();
  const std::optional<PosteriorResult> result = sample_fit(request, terminal_progress());
  if (!result) return;  // another rank answers
  // Keep the draws even if the chains do not agree, then end with an error.
  if (result->run.draws.draws() > 0) deliver(options.outputs, *result);
  std::fflush(stdout);
  require_complete(*result);
  print_warnings(result->outcome.warnings);
  print_warnings(noise_cautions(*result));
  print_warnings(convergence_cautions(result->run));
  complain(convergence_complaint(result->run), options.allow_unconverged);
}

void run_fit(FitArguments& options) {
  require_method(options.method);
  const bool sampling = options.method == kSampling;
  require_endings(options.outputs, sampling);
  sampling ? sample_posterior_of(options) : fit_best(options);
}

void add_chain_options(CLI::App& command, FitArguments& options) {
  CLI::Option_group* const group = command.add_option_group("With --method mcmc");
  // Leave out parameters that fits have, as these are options already.
  const std::vector<Param> fits = fit_params().params();
  std::vector<std::string> known;
  for (const Param& param : fits)
    if (param.member.name != "method") known.push_back(param.member.name);
  add_request_options(*group, without(posterior_params().params(), known), options.chains);
  group->add_flag("--no-retry", options.no_retry,
                  "Keep chains whose trajectories diverge, rather than start over with smaller "
                  "steps (at target acceptances of 0.95 and 0.99)");
}

}  // namespace

void add_fit(CLI::App& app) {
  auto options = std::make_shared<FitArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("fit", "Fit a digit to measured fingertip forces");
  std::vector<Param> params = fit_params().params();
  for (Param& param : params)
    if (param.member.name == "method") param.option = "";
  add_request_options(*command, params, options->fit);
  command->add_option(
      "--method", options->method,
      "Method: ceres, ipopt: by derivatives; nlopt, nlopt-global: without; mcmc: draws from "
      "the posterior instead of one best point");
  command->add_flag("--allow-unconverged", options->allow_unconverged,
                    "Exit without an error even if the fit or the chains have not converged");
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
