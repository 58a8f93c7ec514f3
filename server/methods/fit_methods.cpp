#include <memory>

#include "live/live_fit.h"
#include "server/frame.h"
#include "server/methods/method_table.h"

namespace thenar::internal {
namespace {

/// Returns the components of a force; null for those that were not measured.
OrderedJson components_json(const Eigen::Vector3d& force, const PredictedTrial& trial) {
  OrderedJson list = OrderedJson::array();
  for (int i = 0; i < 3; ++i)
    list.push_back(i < trial.components ? OrderedJson(force[i]) : OrderedJson());
  return list;
}

OrderedJson trial_json(const LiveFit& fit, int index) {
  const LiveTrial& at = fit.trials()[index];
  const Experiment& experiment = fit.source().problem.experiments()[at.experiment];
  const PredictedTrial& trial = fit.predicted(index);
  return {{"trial", index},
          {"experiment", experiment.name},
          {"specimen", experiment.specimen},
          {"posture", trial.posture},
          {"loads", trial.loads},
          {"tensions", experiment.trials[at.trial].tension},
          {"measured", components_json(trial.measured, trial)},
          {"predicted", components_json(trial.predicted, trial)},
          {"sd", components_json(trial.sd, trial)},
          {"residual", components_json(trial.predicted - trial.measured, trial)},
          {"direction_error", direction_error(trial)}};
}

/// Returns a number with the interval that holds 90 % of the draws; for a fit, of length zero.
OrderedJson interval_json(const LiveAxisPair& pair, double AxisOffset::*number) {
  return {{"value", pair.estimate.*number},
          {"lower", pair.lower.*number},
          {"upper", pair.upper.*number}};
}

OrderedJson axes_json(const LiveFit& fit) {
  const TendonDigit& digit = fit.digit();
  OrderedJson axes = OrderedJson::array();
  for (std::size_t i = 0; i < digit.model.tree.size(); ++i)
    axes.push_back({{"joint", digit.names.hinges[i]},
                    {"direction", to_json(digit.model.tree[i].direction)},
                    {"point", to_json(digit.model.tree[i].point)}});
  return axes;
}

OrderedJson pairs_json(const LiveFit& fit) {
  OrderedJson pairs = OrderedJson::array();
  for (const LiveAxisPair& pair : fit.axis_pairs())
    pairs.push_back({{"axes", pair.axes.name},
                     {"angle", interval_json(pair, &AxisOffset::angle)},
                     {"distance", interval_json(pair, &AxisOffset::distance)},
                     {"beyond", interval_json(pair, &AxisOffset::beyond)}});
  return pairs;
}

OrderedJson fit_state_json(const LiveFit& fit) {
  OrderedJson json{{"kind", fit.source().kind},
                   {"subject", fit.source().subject.name},
                   {"digit", fit.source().problem.experiments().front().digit},
                   {"rotation", to_json(quaternion_of(fit.subject_pose().R))},
                   {"trial", fit.shown_trial()},
                   {"trials", OrderedJson::array()}};
  for (int i = 0; i < static_cast<int>(fit.trials().size()); ++i)
    json["trials"].push_back(trial_json(fit, i));
  json["posture"] = to_json(fit.digit().names.coordinates, fit.posture());
  json["axes"] = axes_json(fit);
  json["pairs"] = pairs_json(fit);
  json["warnings"] = fit.warnings();
  return json;
}

OrderedJson open_fit(Session& session, const Json& params, const Progress& progress) {
  progress(0, "reading the fit");
  const auto fit = std::make_shared<LiveFit>(params["file"].get<std::string>());
  session.open(LiveMode::kFit, fit);
  return fit_state_json(*fit);
}

OrderedJson show_trial(Session& session, const Json& params, const Progress& /*progress*/) {
  auto& fit = session.model<LiveFit>(LiveMode::kFit);
  fit.show_trial(params["trial"].get<int>());
  OrderedJson json = trial_json(fit, fit.shown_trial());
  json["posture_angles"] = to_json(fit.digit().names.coordinates, fit.posture());
  json["warnings"] = fit.warnings();
  return json;
}

constexpr const char* kFitWords =
    "kind: fit or posterior; subject, digit; rotation of the picture against the subject's frame; "
    "trial: which is shown; trials: trial, experiment, specimen, posture, loads, tensions [N], "
    "measured, predicted, sd and residual of the forces in the experiment's components [N], null "
    "where not measured, direction_error [rad]; posture: angles with their fitted errors [rad]; "
    "axes of the specimen that is shown, subject's frame, reference posture: joint, direction, "
    "point [m]; pairs of neighbouring axes: angle [rad], distance [m] and how far the second lies "
    "distal of the first [m], each value (of a posterior the mean of its draws), lower and upper "
    "(90 % of its draws lie between); warnings";

constexpr int kMaxTrials = 1000000;  // upper bound of the schema; LiveFit checks the number

}  // namespace

void add_fit_methods(MethodTable& table) {
  table.add(
      {"fit.open",
       "Opens the result of a fit or draws from a posterior, and shows the first trial.",
       object_schema({{"file", text_schema(), "Result of a fit (.h5) or posterior (.nc).", true}}),
       std::string("As fit.state: ") + kFitWords, R"({"file": "fit.h5"})", open_fit});
  table.add({"fit.state", "Lists the trials with their forces, and the joint axes.",
             object_schema({}), kFitWords, "{}",
             [](Session& session, const Json&, const Progress&) {
               return fit_state_json(session.model<LiveFit>(LiveMode::kFit));
             }});
  table.add({"fit.trial", "Shows a trial: its posture, tensions and forces.",
             object_schema({{"trial", integer_schema(0, kMaxTrials), "Counted from 0.", true}}),
             "The entry of trials of fit.state; posture_angles with their fitted errors [rad]; "
             "warnings.",
             R"({"trial": 0})", show_trial});
}

}  // namespace thenar::internal
