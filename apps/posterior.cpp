// thenar posterior summary|plot|predict POSTERIOR.nc
//
// What the draws of `thenar fit --method mcmc` say.

#include "api/posterior.h"

#include <memory>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "report/answers/posterior.h"
#include "report/pages/posterior.h"

namespace thenar {
namespace {

struct PosteriorArguments {
  PosteriorPredictRequest request;  // its posterior is used by all three commands
  std::size_t rows = 20;
  bool allow_unconverged = false;
  Outputs outputs;
};

void warn_of(const PosteriorRun& run, bool allowed) {
  print_warnings(convergence_cautions(run));
  complain(convergence_complaint(run), allowed);
}

void summary(const PosteriorArguments& options) {
  PosteriorResult result = open_posterior(options.request.posterior);
  result.rows = options.rows;
  print_warnings(result.outcome.warnings);
  print_warnings(noise_cautions(result));
  deliver(options.outputs, result);
  warn_of(result.run, options.allow_unconverged);
}

void plot(const PosteriorArguments& options) {
  require(options.outputs.page(), "wanted a page to write: -o P.html");
  const PosteriorResult result = open_posterior(options.request.posterior);
  print_warnings(result.outcome.warnings);
  print_warnings(noise_cautions(result));
  for (const std::string& path : options.outputs.with_ending({".html"}))
    write_page(page_of(result), path, files_of(result));
  print_written(options.outputs);
  warn_of(result.run, options.allow_unconverged);
}

void predict(const PosteriorArguments& options) {
  const PosteriorPrediction result = predict_by_draws(options.request);
  print_warnings(result.outcome.warnings);
  deliver(options.outputs, result);
  warn_of(result.posterior.run, options.allow_unconverged);
}

CLI::App* add(CLI::App& parent, const char* name, const char* text,
              const std::shared_ptr<PosteriorArguments>& options,
              void (*run)(const PosteriorArguments&)) {
  CLI::App* command = parent.add_subcommand(name, text);
  command
      ->add_option("posterior", options->request.posterior,
                   "Result file of `thenar fit --method mcmc` (.nc)")
      ->required();
  command->add_flag("--allow-unconverged", options->allow_unconverged,
                    "Exit without an error even if the chains have not converged");
  command->callback([options, run] { run(*options); });
  return command;
}

}  // namespace

void add_posterior(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("posterior", "Summarise, plot or predict from posterior samples");
  command->require_subcommand(1);
  const std::string make = "fit synek2019_H01 --subject synek2019_middle --method mcmc -o out/P.nc";
  // All three read a posterior, and share its arguments.
  auto options = std::make_shared<PosteriorArguments>();  // lives as long as the callbacks
  CLI::App* first =
      add(*command, "summary", "Summarise convergence, parameters and modes", options, summary);
  first->add_option("--rows", options->rows, "Parameters to print");
  add_output_options(*first, options->outputs, {true, true, true});
  add_examples(*first, {make, "posterior summary out/P.nc --rows 10 -o out/P.csv"});
  CLI::App* second = add(*command, "plot", "Write a report page (.html)", options, plot);
  add_output_options(*second, options->outputs, {false, false, true});
  add_examples(*second, {make, "posterior plot out/P.nc -o out/P.html"});
  CLI::App* third =
      add(*command, "predict", "Predict the forces of any experiment", options, predict);
  third
      ->add_option("experiments", options->request.experiments,
                   "Experiments: names, or files (TOML)")
      ->required()
      ->default_str("");
  third->add_option("--draws", options->request.draws, "Draws to predict with")
      ->check(CLI::PositiveNumber);
  third->add_flag("--population", options->request.population,
                  "Predict a fitted specimen as if it had never been seen");
  add_fit_path_option(*third, options->request.path);
  add_data_option(*third, options->request.data);
  add_output_options(*third, options->outputs, {true, true, true});
  add_examples(*third, {make, "posterior predict out/P.nc synek2019_H02 --csv"});
  // Last: a command made later would begin with the examples of the one above.
  add_examples(*command, {make, "posterior summary out/P.nc"});
}

}  // namespace thenar
