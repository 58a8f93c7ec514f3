// thenar predict FIT.h5 EXPERIMENT...
//
// Predicts the forces of any experiment on the fitted digit, also of a specimen that was never
// fitted, and compares them with what was measured.

#include <memory>

#include "api/predict.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "report/answers/prediction.h"
#include "report/pages/prediction.h"

namespace thenar {
namespace {

struct PredictArguments {
  PredictRequest request;
  Outputs outputs;
};

void run_predict(const PredictArguments& options) {
  const PredictResult result = predict_forces(options.request);
  print_warnings(result.outcome.warnings);
  deliver(options.outputs, result);
}

}  // namespace

void add_predict(CLI::App& app) {
  auto options = std::make_shared<PredictArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("predict", "Predict the forces of an experiment");
  PredictRequest& request = options->request;
  command->add_option("fit", request.fit, "Result file of `thenar fit` (.h5)")->required();
  command->add_option("experiments", request.experiments, "Experiments: names, or files (TOML)")
      ->required()
      ->default_str("");
  command->add_flag("--population", request.population,
                    "Predict a fitted specimen as if it had never been seen");
  add_fit_path_option(*command, request.path);
  add_data_option(*command, request.data);
  add_output_options(*command, options->outputs, {true, true, true});
  add_examples(*command, {"fit synek2019_H01 --subject an_chao_middle -o out/fit.h5",
                          "predict out/fit.h5 synek2019_B01 --report out/predicted.html"});
  command->callback([options] { run_predict(*options); });
}

}  // namespace thenar
