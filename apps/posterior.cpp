// thenar posterior summary|plot|predict POSTERIOR.nc
//
// What the draws of `thenar fit --method mcmc` say.

#include <memory>

#include <fmt/format.h>

#include "api/files.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/posterior_summary.h"
#include "apps/print_prediction.h"
#include "apps/terminal.h"
#include "base/file_io.h"
#include "kinematics_fit/experiment_plan.h"
#include "posterior/run/posterior_file.h"
#include "posterior/run/predict_draws.h"
#include "report/json.h"
#include "report/page.h"
#include "report/pages/posterior_picture.h"
#include "report/provenance.h"

namespace thenar {
namespace {

struct PosteriorArguments {
  std::string posterior, output;
  std::vector<std::string> experiments;
  std::size_t rows = 20;
  long draws = 2000;
  bool json = false, population = false, allow_unconverged = false;
};

void summary(const PosteriorArguments& options) {
  require_kind(options.posterior, {"posterior"});
  const PosteriorRun run = read_posterior(options.posterior);
  print_warnings(checksum_warnings(options.posterior));
  if (options.json)
    fmt::print("{}\n", json_text(summary_json(run)));
  else
    print_summary(run, options.rows);
  require_converged(run, options.allow_unconverged);
}

Json provenance(const PosteriorRun& run) {
  std::vector<SourceText> sources = run.inputs.experiments;
  sources.insert(sources.end(), {run.inputs.subject, run.inputs.settings});
  Json out = provenance_json(sources, run.posterior->problem().digit().fidelity);
  out["seed"] = fmt::format("{}", run.settings.run.sampler.seed);
  return out;
}

void plot(const PosteriorArguments& options) {
  require_ending(options.output, {".html"});
  require_writable(options.output);
  require_kind(options.posterior, {"posterior"});
  const PosteriorRun run = read_posterior(options.posterior);
  print_warnings(checksum_warnings(options.posterior));
  std::string title;
  for (const std::string& specimen : run.posterior->problem().specimens())
    title += (title.empty() ? "" : ", ") + specimen;
  write_report({{"title", "thenar: posterior of " + title},
                {"subtitle", describe_run(run)},
                {"provenance", provenance(run)},
                {"sections", posterior_sections(posterior_picture(run))}},
               options.output);
  fmt::print("wrote {}\n", options.output);
  require_converged(run, options.allow_unconverged);
}

void predict(const PosteriorArguments& options) {
  require_kind(options.posterior, {"posterior"});
  const PosteriorRun run = read_posterior(options.posterior);
  print_warnings(checksum_warnings(options.posterior));
  nlohmann::json out = nlohmann::json::array();
  for (const std::string& path : options.experiments) {
    const Experiment experiment = read_experiment(path);
    const FitProblem& problem = run.posterior->problem();
    const int fitted = find_specimen(problem, experiment.specimen);
    const PredictedBy by = predicted_by(fitted, options.population);
    for (const std::string& warning : experiment_warnings(
             problem.digit(), plan_experiment(problem.digit(), problem.parameters(), experiment),
             experiment))
      fmt::print(stderr, "thenar: warning: {}\n", warning);
    const Prediction prediction = summarise(predict_draws(
        run, experiment, by == PredictedBy::kOwn ? fitted : kUnfittedSpecimen, options.draws));
    if (options.json)
      out.push_back(prediction_json(prediction, experiment.specimen, by));
    else
      print_prediction(prediction, experiment, by);
  }
  if (options.json) fmt::print("{}\n", json_text(out.size() == 1 ? out[0] : out));
  require_converged(run, options.allow_unconverged);
}

CLI::App* add(CLI::App& parent, const char* name, const char* text,
              const std::shared_ptr<PosteriorArguments>& options,
              void (*run)(const PosteriorArguments&)) {
  CLI::App* command = parent.add_subcommand(name, text);
  command->add_option("posterior", options->posterior, "Result file of `thenar fit --method mcmc`")
      ->required();
  command->add_flag("--allow-unconverged", options->allow_unconverged,
                    "Do not fail if the chains have not converged");
  command->callback([options, run] { run(*options); });
  return command;
}

}  // namespace

void add_posterior(CLI::App& app) {
  CLI::App* command = app.add_subcommand("posterior", "What sampled parameters say");
  command->require_subcommand(1);
  auto options = std::make_shared<PosteriorArguments>();  // lives as long as the callbacks
  CLI::App* first = add(*command, "summary", "Parameters, convergence, modes", options, summary);
  first->add_option("--rows", options->rows, "Parameters to print");
  first->add_flag("--json", options->json, "Print JSON");
  CLI::App* second = add(*command, "plot", "A page to look at", options, plot);
  second->add_option("-o,--output", options->output, "Page (.html)")->required();
  CLI::App* third = add(*command, "predict", "Forces of any experiment", options, predict);
  third->add_option("experiments", options->experiments, "Experiment files")->required();
  third->add_option("--draws", options->draws, "Draws to predict with")->check(CLI::PositiveNumber);
  third->add_flag("--population", options->population,
                  "Predict a fitted specimen as if it had never been seen");
  third->add_flag("--json", options->json, "Print JSON");
}

}  // namespace thenar
