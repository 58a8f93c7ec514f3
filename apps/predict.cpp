// thenar predict FIT.h5 EXPERIMENT.toml...
//
// Predicts the forces of any experiment on the fitted digit, also of a specimen that was never
// fitted, and compares them with what was measured.

#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "api/files.h"
#include "apps/commands.h"
#include "apps/print_prediction.h"
#include "apps/terminal.h"
#include "kinematics_fit/experiment_plan.h"
#include "kinematics_fit/prediction.h"
#include "report/json.h"

namespace thenar {
namespace {

struct PredictArguments {
  std::string fit;
  std::vector<std::string> experiments;
  bool population = false;
  bool json = false;
};

void warn(const std::string& what) { fmt::print(stderr, "thenar: warning: {}\n", what); }

void run_predict(const PredictArguments& options) {
  require_kind(options.fit, {"fit"});
  const Fit fit = read_fit(options.fit);
  print_warnings(checksum_warnings(options.fit));
  if (fit.solution.status != Status::kSolved)
    warn(fmt::format("the fit in '{}' did not converge: {}", options.fit,
                     convergence_word(fit.solution)));
  nlohmann::json out = nlohmann::json::array();
  for (const std::string& path : options.experiments) {
    const Experiment experiment = read_experiment(path);
    const int fitted = find_specimen(fit.problem, experiment.specimen);
    const PredictedBy by = predicted_by(fitted, options.population);
    for (const std::string& warning : experiment_warnings(
             fit.problem.digit(),
             plan_experiment(fit.problem.digit(), fit.problem.parameters(), experiment),
             experiment))
      warn(warning);
    const Prediction prediction =
        predict_experiment(fit.problem, fit.solution.z, fit.covariance.C, experiment,
                           by == PredictedBy::kOwn ? fitted : kUnfittedSpecimen);
    if (options.json)
      out.push_back(prediction_json(prediction, experiment.specimen, by));
    else
      print_prediction(prediction, experiment, by);
  }
  if (options.json) fmt::print("{}\n", json_text(out.size() == 1 ? out[0] : out));
}

}  // namespace

void add_predict(CLI::App& app) {
  auto options = std::make_shared<PredictArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("predict", "Predict the forces of an experiment");
  command->add_option("fit", options->fit, "Result file of `thenar fit`")->required();
  command->add_option("experiments", options->experiments, "Experiment files")->required();
  command->add_flag("--population", options->population,
                    "Predict a fitted specimen as if it had never been seen");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run_predict(*options); });
}

}  // namespace thenar
