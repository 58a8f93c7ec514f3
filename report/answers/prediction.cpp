#include "report/answers/prediction.h"

#include <fmt/format.h>

#include "base/units.h"
#include "report/answers/fit.h"
#include "report/words.h"

namespace thenar {
namespace {

/// Components side by side, "-" for one that is not fitted.
std::string in_columns(const Eigen::Vector3d& v, int components, int width, int digits) {
  std::string text;
  for (int i = 0; i < 3; ++i)
    text += i < components ? fmt::format("{:{}.{}f}", v[i], width, digits)
                           : fmt::format("{:>{}}", "-", width);
  return text;
}

/// Returns components as cells of a table, empty for components that are not fitted.
std::vector<std::string> component_cells(const Eigen::Vector3d& v, int components) {
  std::vector<std::string> list = cells(v.head(components), 6);
  list.resize(3);
  return list;
}

std::string experiment_text(const PredictedExperiment& one) {
  const Prediction& prediction = one.prediction;
  std::string text = fmt::format("{}: specimen {} {}\n", prediction.experiment,
                                 one.experiment.specimen, in_words(one.by));
  if (prediction.calibrated_on_specimen)
    text += "  the subject that the fit started from has seen this specimen\n";
  text += fmt::format("  forces are ({}) of {}\n", component_names(one.experiment),
                      one.experiment.force_segment);
  // Measured, predicted and sd of each trial, then the errors of all.
  text += fmt::format("  {:<12} {:<10} {:>24} {:>24} {:>20} {:>7} {:>6}\n", "posture", "loads",
                      "measured [N]", "predicted [N]", "sd [N]", "err [N]", "deg");
  for (const PredictedTrial& t : prediction.trials)
    text += fmt::format("  {:<12} {:<10} {} {}   {} {:7.3f} {:6.1f}\n", t.posture, t.loads,
                        in_columns(t.measured, t.components, 8, 3),
                        in_columns(t.predicted, t.components, 8, 3),
                        in_columns(t.sd, t.components, 6, 2), (t.predicted - t.measured).norm(),
                        degrees(direction_error(t)));
  text += fmt::format(
      "  RMS error {:.3f} N, relative error {:.3f}{}, median direction error {:.1f} deg\n",
      prediction.error.rms, prediction.error.relative,
      one.by == PredictedBy::kOwn ? trivial_words(prediction, "its single loads added up")
                                  : trivial_words(prediction),
      degrees(prediction.error.direction));
  if (prediction.error.covered)
    text += fmt::format("  {:.0f} % of components within the 95 % interval\n",
                        100 * *prediction.error.covered);
  return text;
}

Fields experiment_fields(const PredictedExperiment& one) {
  const Prediction& prediction = one.prediction;
  const auto trial_fields = [](const PredictedTrial& trial) {
    return Fields{{"posture", trial.posture},
                  {"loads", trial.loads},
                  {"measured", units::kNewton, trial.measured.head(trial.components)},
                  {"predicted", units::kNewton, trial.predicted.head(trial.components)},
                  {"sd", units::kNewton, trial.sd.head(trial.components)},
                  {"error", units::kNewton, (trial.predicted - trial.measured).norm()},
                  {"direction_error", units::kDegree, direction_error(trial)}};
  };
  const bool own = one.by == PredictedBy::kOwn;
  return {{"experiment", prediction.experiment},
          {"specimen", one.experiment.specimen},
          {"specimen_was_fitted", one.by != PredictedBy::kStranger},
          {"predicted_by", own ? "own parameters" : "population"},
          {"start_has_seen_specimen", prediction.calibrated_on_specimen},
          {"rms_error", units::kNewton, prediction.error.rms},
          {"relative_error", prediction.error.relative},
          {"relative_error_flexion_plane", prediction.error.relative_flexion},
          {"direction_error", units::kDegree, prediction.error.direction},
          {"covered_95", units::kOne, prediction.error.covered},
          trivial_field(own ? "superposition" : "mean_of_others", prediction),
          {own ? "mean_of_others" : "superposition", nullptr},
          {"vectors", fields_of_each(prediction.trials, trial_fields)}};
}

}  // namespace

std::string refusal_of(const PredictResult& result) {
  if (result.outcome.status != Status::kStalled) return "";
  return fmt::format("the fit in '{}' has NOT converged; do not use these forces",
                     result.request.fit);
}

std::string component_names(const Experiment& experiment) {
  std::string names;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (experiment.axes_of_digit(i, k) != 0)
        names += (i > 0 ? " " : "") +
                 std::string(kDirectionWords[k][experiment.axes_of_digit(i, k) < 0 ? 1 : 0]);
  return names;
}

std::string in_words(PredictedBy by) {
  if (by == PredictedBy::kOwn) return "was fitted; its own parameters predict";
  if (by == PredictedBy::kOwnPopulation)
    return "was fitted; the population, of which it is a part, predicts";
  return "was never fitted; the population predicts";
}

std::string text_of(const PredictResult& result) {
  return each_in_words(result.experiments, experiment_text, "");
}

std::vector<Fields> fields_of(const PredictResult& result) {
  return fields_of_each(result.experiments, experiment_fields);
}

Table table_of(const PredictResult& result) {
  Table table{{"experiment", "specimen", "posture", "loads", "components", "measured_1_N",
               "measured_2_N", "measured_3_N", "predicted_1_N", "predicted_2_N", "predicted_3_N",
               "sd_1_N", "sd_2_N", "sd_3_N", "error_N", "direction_error_deg"}};
  for (const PredictedExperiment& one : result.experiments)
    for (const PredictedTrial& trial : one.prediction.trials)
      table.add_parts({{one.prediction.experiment, one.experiment.specimen, trial.posture,
                        trial.loads, component_names(one.experiment)},
                       component_cells(trial.measured, trial.components),
                       component_cells(trial.predicted, trial.components),
                       component_cells(trial.sd, trial.components),
                       {shown((trial.predicted - trial.measured).norm(), 6),
                        shown(degrees(direction_error(trial)), 3)}});
  return table;
}

}  // namespace thenar
