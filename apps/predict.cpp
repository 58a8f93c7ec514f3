// thenar predict FIT.h5 EXPERIMENT.toml...
//
// Predicts the forces of any experiment on the fitted digit, also of a specimen that was never
// fitted, and compares them with what was measured.

#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/commands.h"
#include "apps/read_source.h"
#include "base/angles.h"
#include "kinematics_fit/experiment_warnings.h"
#include "kinematics_fit/prediction.h"

namespace thenar {
namespace {

struct Options {
  std::string fit;
  std::vector<std::string> experiments;
  bool population = false;
  bool json = false;
};

std::vector<double> list(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

void warn(const std::string& what) { fmt::print(stderr, "thenar: warning: {}\n", what); }

nlohmann::json to_json(const Prediction& prediction, const std::string& specimen, bool fitted) {
  nlohmann::json vectors = nlohmann::json::array();
  for (const PredictedTrial& trial : prediction.trials)
    vectors.push_back({{"posture", trial.posture},
                       {"loads", trial.loads},
                       {"measured_N", list(trial.measured)},
                       {"predicted_N", list(trial.predicted)},
                       {"sd_N", list(trial.sd)},
                       {"error_N", (trial.predicted - trial.measured).norm()},
                       {"direction_error_deg", degrees(direction_error(trial))}});
  return {{"experiment", prediction.experiment},
          {"specimen", specimen},
          {"specimen_was_fitted", fitted},
          {"rms_error_N", prediction.error.rms},
          {"relative_error", prediction.error.relative},
          {"relative_error_flexion_plane", prediction.error.relative_flexion},
          {"direction_error_deg", degrees(prediction.error.direction)},
          {"covered_95",
           prediction.error.covered ? nlohmann::json(*prediction.error.covered) : nlohmann::json()},
          {"vectors", vectors}};
}

/// "proximal dorsal -radial": what the three components of a force are.
std::string component_names(const Experiment& experiment) {
  constexpr const char* kNames[] = {"proximal", "dorsal", "radial"};
  std::string names;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (experiment.axes_of_digit(i, k) != 0)
        names += fmt::format("{}{}{}", i > 0 ? " " : "",
                             experiment.axes_of_digit(i, k) < 0 ? "-" : "", kNames[k]);
  return names;
}

void print(const Prediction& prediction, const Experiment& experiment, bool fitted) {
  fmt::print("{}: specimen {} {}\n", prediction.experiment, experiment.specimen,
             fitted ? "was fitted; its own parameters predict"
                    : "was never fitted; the population predicts");
  fmt::print("  forces are ({}) of {}\n", component_names(experiment), experiment.force_segment);
  fmt::print("  {:<12} {:<10} {:>24} {:>24} {:>20} {:>7} {:>6}\n", "posture", "loads",
             "measured [N]", "predicted [N]", "sd [N]", "err [N]", "deg");
  for (const PredictedTrial& t : prediction.trials)
    fmt::print(
        "  {:<12} {:<10} {:8.3f}{:8.3f}{:8.3f} {:8.3f}{:8.3f}{:8.3f}   {:6.2f}{:6.2f}{:6.2f} "
        "{:7.3f} {:6.1f}\n",
        t.posture, t.loads, t.measured.x(), t.measured.y(), t.measured.z(), t.predicted.x(),
        t.predicted.y(), t.predicted.z(), t.sd.x(), t.sd.y(), t.sd.z(),
        (t.predicted - t.measured).norm(), degrees(direction_error(t)));
  fmt::print("  RMS error {:.3f} N, relative error {:.3f}, median direction error {:.1f} deg\n",
             prediction.error.rms, prediction.error.relative, degrees(prediction.error.direction));
  if (prediction.error.covered)
    fmt::print("  {:.0f} % of components within the 95 % interval\n",
               100 * *prediction.error.covered);
}

void run(const Options& options) {
  const Fit fit = read_fit(options.fit);
  if (fit.solution.status != SolveStatus::kConverged)
    warn(fmt::format("the fit in '{}' did not converge: {}", options.fit,
                     name_of(fit.solution.status)));
  nlohmann::json out = nlohmann::json::array();
  for (const std::string& path : options.experiments) {
    const Experiment experiment = read_experiment(path);
    const int specimen = options.population ? -1 : find_specimen(fit.problem, experiment.specimen);
    for (const std::string& warning : experiment_warnings(
             fit.problem.digit(),
             plan_experiment(fit.problem.digit(), fit.problem.parameters(), experiment),
             experiment))
      warn(warning);
    const Prediction prediction =
        predict_experiment(fit.problem, fit.solution.z, fit.covariance.C, experiment, specimen);
    if (options.json)
      out.push_back(to_json(prediction, experiment.specimen, specimen >= 0));
    else
      print(prediction, experiment, specimen >= 0);
  }
  if (options.json) fmt::print("{}\n", (out.size() == 1 ? out[0] : out).dump(2));
}

}  // namespace

void add_predict(CLI::App& app) {
  auto options = std::make_shared<Options>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("predict", "Predict the forces of an experiment");
  command->add_option("fit", options->fit, "Result file of `thenar fit`")->required();
  command->add_option("experiments", options->experiments, "Experiment files")->required();
  command->add_flag("--population", options->population,
                    "Predict a fitted specimen as if it had never been seen");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run(*options); });
}

}  // namespace thenar
