#include "api/predict.h"

#include <fmt/format.h>

#include "api/fit.h"
#include "api/named/files.h"
#include "base/error.h"
#include "base/lists.h"
#include "kinematics_fit/model/experiment_plan.h"
#include "kinematics_fit/model/shared_postures.h"
#include "kinematics_fit/trivial_prediction.h"

namespace thenar {
namespace {

/// Returns an answer without its experiments.
PredictResult answer_of(const PredictRequest& request, const Fit& fit) {
  PredictResult result{request, {}, fit.inputs, fit.run, fit.problem.digit().fidelity, {}, {}};
  result.outcome.warn(checksum_warnings(request.fit));
  // The forces of a point that is no minimum are computed, but not to be used.
  if (!fit.solution.converged()) {
    result.outcome.status = Status::kStalled;
    result.outcome.warnings.push_back(fmt::format("the fit in '{}' did not converge: {}",
                                                  request.fit, convergence_word(fit.solution)));
  }
  result.outcome.warn(path_cautions(fit.inputs));
  return result;
}

}  // namespace

Prediction beside_trivial_forces(Prediction prediction, const Experiment& experiment,
                                 const FitProblem& fitted, PredictedBy by) {
  for (std::size_t i = 0; i < prediction.trials.size(); ++i) {
    const Trial& trial = experiment.trials[i];
    if (by == PredictedBy::kStranger)
      prediction.trials[i].trivial = trivial_force(experiment, trial, fitted.experiments());
    if (by == PredictedBy::kOwn)
      prediction.trials[i].trivial = superposed_force(experiment, trial, fitted.experiments());
  }
  return prediction;
}

PredictedBy predicted_by(int specimen, bool population) {
  if (specimen < 0) return PredictedBy::kStranger;
  return population ? PredictedBy::kOwnPopulation : PredictedBy::kOwn;
}

Experiment read_trials(const SourceText& source) {
  Experiment experiment = parse_experiment(source.text, source.path);
  require(!experiment.trials.empty(),
          "{}: wanted trials, whose forces could be predicted, got rows of activations alone",
          source.path);
  return experiment;
}

std::vector<std::string> prediction_warnings(const FitProblem& fitted,
                                             const Experiment& experiment) {
  const TendonDigit digit = fitted.sized_digit(experiment);
  std::vector<std::string> warnings = experiment_warnings(
      digit, plan_experiment(digit, fitted.parameters(), experiment), experiment);
  append_all(warnings,
             posture_name_warnings({with_own_postures(experiment, fitted.experiments())}));
  return warnings;
}

void add_predictions(const FitProblem& problem, const PredictSpecimen& predict,
                     PredictResult& result) {
  // Predict each experiment by its own specimen if that was fitted, else by the population.
  for (const std::string& name : result.request.experiments) {
    const SourceText source = read_source(experiment_file(name, result.request.data));
    const Experiment experiment = read_trials(source);
    result.outcome.warn(prediction_warnings(problem, experiment));
    const int fitted = find_specimen(problem, experiment.specimen);
    const PredictedBy by = predicted_by(fitted, result.request.population);
    Prediction prediction =
        predict(experiment, by == PredictedBy::kOwn ? fitted : kUnfittedSpecimen);
    // Warn of medians of draws, then set trivial predictions beside: a model has to beat them.
    result.outcome.warn(unsteady_force_warnings(prediction));
    result.sources.push_back(source);
    result.experiments.push_back(
        {experiment, beside_trivial_forces(std::move(prediction), experiment, problem, by), by});
  }
}

PredictResult predict_forces(const PredictRequest& request) {
  require_field("experiments", !request.experiments.empty(),
                "wanted at least one experiment to predict");
  require_fit_path(request.path);
  in_field("fit", [&] { require_kind(request.fit, {"fit"}); });
  const Fit fit = read_fit(request.fit);
  PredictResult result = answer_of(request, fit);
  const auto predict = [&](const Experiment& experiment, int specimen) {
    return predict_experiment(fit.problem, fit.solution.z, fit.covariance.C, experiment, specimen);
  };
  add_predictions(fit.problem, predict, result);
  return result;
}

}  // namespace thenar
