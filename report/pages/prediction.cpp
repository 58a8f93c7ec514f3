#include "report/pages/prediction.h"

#include <fmt/format.h>

#include "base/units.h"
#include "kinematics_fit/trivial_prediction.h"
#include "report/answers/prediction.h"
#include "report/provenance.h"

namespace thenar {
namespace {

/// The two components of a force that one plane shows; [horizontal, vertical].
struct Plane {
  const char* name;
  const char* x_label;
  const char* y_label;
  int x, y;  // components
};
constexpr Plane kPlanes[] = {
    {"flexion plane", "distal \u2190 \u2192 proximal [N]", "palmar \u2190 \u2192 dorsal [N]", 0, 1},
    {"lateral plane", "ulnar \u2190 \u2192 radial [N]", "palmar \u2190 \u2192 dorsal [N]", 2, 1}};

Json arrow(const PredictedTrial& trial, const Plane& plane) {
  const auto pick = [&](const Eigen::Vector3d& v) { return Json::array({v[plane.x], v[plane.y]}); };
  Json out{{"group", trial.loads},
           {"measured", pick(trial.measured)},
           {"predicted", pick(trial.predicted)}};
  if (trial.sd.head(trial.components).minCoeff() > 0) out["predicted_sd"] = pick(trial.sd);
  return out;
}

/// Panels in the order in which postures first appear.
Json panels(const Prediction& prediction, const Plane& plane) {
  Json out = Json::array();
  for (const PredictedTrial& trial : prediction.trials)
    entry_named(out, "title", trial.posture, "arrows")["arrows"].push_back(arrow(trial, plane));
  return out;
}

Json error_table(const PredictedExperiment& one) {
  const ForceError& error = one.prediction.error;
  return table_block(
      "Errors of all trials: in space, in the flexion plane alone, and the median angle between "
      "predicted and measured",
      {"trials:0", "RMS error [N]:3", "relative error:3", "in plane:3", "angle [deg]:1",
       "within 95 % band [%]:0"},
      Json::array({{error.trials, error.rms, error.relative, error.relative_flexion,
                    degrees(error.direction),
                    error.covered ? Json(100 * *error.covered) : Json(nullptr)}}));
}

Json trial_table(const PredictedExperiment& one) {
  Json rows = Json::array();
  // Components that were not measured are left empty.
  for (const PredictedTrial& t : one.prediction.trials) {
    Json cells = Json::array({t.posture, t.loads});
    for (const Eigen::Vector3d& v : {t.measured, t.predicted, t.sd})
      for (int i = 0; i < 3; ++i) cells.push_back(i < t.components ? Json(v[i]) : Json(nullptr));
    cells.push_back((t.predicted - t.measured).norm());
    cells.push_back(degrees(direction_error(t)));
    rows.push_back(std::move(cells));
  }
  std::vector<BlockColumn> columns{"posture", "loads"};
  for (const char* what : {"measured", "predicted", "sd"})
    for (const char* component : {"1", "2", "3"})
      columns.push_back({fmt::format("{} {}", what, component), "N", 3});
  columns.emplace_back("error [N]:3");
  columns.emplace_back("angle [deg]:1");
  return with(
      table_block(fmt::format("Every trial; its components are ({}) of {}",
                              component_names(one.experiment), one.experiment.force_segment),
                  columns, rows),
      {{"search", true}});
}

/// One section for each experiment: who predicts, errors, arrows with their bands, and every trial.
Json prediction_sections(const PredictResult& result) {
  Json sections = Json::array();
  // Say first whether the specimen was fitted, as errors mean different things.
  for (const PredictedExperiment& one : result.experiments) {
    std::string text = fmt::format("Specimen {} {}.", one.experiment.specimen, in_words(one.by));
    if (one.prediction.calibrated_on_specimen)
      text +=
          " The subject that the fit started from has seen this specimen: the error is not that of "
          "an unseen specimen.";
    const Prediction turned = in_digit_axes(one.prediction, one.experiment);
    Json blocks = Json::array({error_table(one)});
    if (std::optional<Json> table = beside_trivial_table(turned)) blocks.push_back(*table);
    blocks.push_back(
        force_panels(turned, one.prediction.experiment +
                                 ". Measured solid, predicted dashed; ellipses hold 95 % of the "
                                 "predictive distribution: what is not known of the parameters, "
                                 "and the noise"));
    blocks.push_back(trial_table(one));
    sections.push_back(section(fmt::format("prediction-{}", sections.size() + 1),
                               one.prediction.experiment + ": measured and predicted forces", text,
                               blocks));
  }
  return sections;
}

}  // namespace

Json force_panels(const Prediction& prediction, const std::string& caption) {
  // The lateral plane needs the component across the plane of flexion.
  const bool in_space =
      all_of(prediction.trials, [](const PredictedTrial& t) { return t.components == 3; });
  Json planes = Json::array();
  for (const Plane& plane : kPlanes)
    if (in_space || plane.x < 2)
      planes.push_back({{"name", plane.name},
                        {"x_label", plane.x_label},
                        {"y_label", plane.y_label},
                        {"panels", panels(prediction, plane)}});
  return {{"type", "vectors"}, {"caption", caption}, {"planes", planes}};
}

Prediction in_digit_axes(Prediction prediction, const Experiment& experiment) {
  const Eigen::Matrix3d to_digit = experiment.axes_of_digit.cast<double>().transpose();
  for (PredictedTrial& trial : prediction.trials) {
    trial.measured = to_digit * trial.measured;
    trial.predicted = to_digit * trial.predicted;
    trial.sd.tail(3 - trial.components).setZero();  // infinite: nothing is known of them
    trial.sd = to_digit.cwiseAbs() * trial.sd;
    if (trial.trivial) trial.trivial = to_digit * *trial.trivial;
  }
  return prediction;
}

std::optional<Json> beside_trivial_table(const Prediction& prediction) {
  // A model has to beat the forces of others, taken as they are.
  Json rows = Json::array();
  for (const ErrorsOfLoad& one : errors_by_load(prediction)) {
    Json row{one.loads, one.trials};
    for (int i = 0; i < 3; ++i)
      for (const Eigen::Vector3d* rms : {&one.measured, &one.model, &one.trivial})
        row.push_back((*rms)[i]);
    rows.push_back(row);
  }
  if (rows.empty()) return std::nullopt;
  std::vector<BlockColumn> columns{"loaded", "trials:0"};
  for (const char* direction : {"proximal", "dorsal", "radial"})
    for (const char* what : {direction, "model off", "others off"})
      columns.push_back({what, "N", 2});
  return table_block(
      fmt::format(
          "{}: root mean squares by muscle and direction: measured, then how far off the "
          "model is, and the mean of others (the force that they measured under the same "
          "load, per newton of tension). Where the last is smaller, the model has not helped",
          prediction.experiment),
      columns, rows);
}

Json caution_banner(const std::vector<std::string>& warnings) {
  return with(banner_block("Before trusting the predictions", warnings), {{"caution", true}});
}

Json page_of(const PredictResult& result) {
  // Sum up by the relative error of each experiment.
  std::vector<std::string> errors;
  std::size_t trials = 0;
  for (const PredictedExperiment& each : result.experiments) {
    trials += each.prediction.trials.size();
    errors.push_back(
        fmt::format("{:.3f} ({})", each.prediction.error.relative, each.prediction.experiment));
  }
  Json sections = prediction_sections(result);
  if (!result.outcome.warnings.empty())
    sections[0]["blocks"].insert(sections[0]["blocks"].begin(),
                                 caution_banner(result.outcome.warnings));
  return {{"title", "thenar: predicted fingertip forces"},
          {"subtitle", "by " + result.request.fit},
          {"opening",
           opening_json(
               "Which fingertip forces follow from " + result.request.fit + "?",
               fmt::format("{} trials were predicted and put beside what was measured.", trials),
               fmt::format("The relative error is {}.", fmt::join(errors, ", ")))},
          {"provenance",
           fit_provenance(result.inputs, result.sources, result.fidelity, result.fitted_by)},
          {"sections", sections}};
}

Json fit_provenance(const FitInputs& inputs, const std::vector<SourceText>& more,
                    const Fidelity& fidelity, const RunRecord& fitted_by) {
  std::vector<SourceText> sources = sources_of(inputs);
  sources.insert(sources.end(), more.begin(), more.end());
  Json out = provenance_json(sources, fidelity);
  if (fitted_by.arguments.empty()) return out;
  out["fitted by"] = command_line(fitted_by);
  out["fitted in"] = fitted_by.folder;
  out["fitted on"] = fitted_by.date;
  if (!fitted_by.commit.empty()) out["fitted with commit"] = fitted_by.commit;
  return out;
}

}  // namespace thenar
