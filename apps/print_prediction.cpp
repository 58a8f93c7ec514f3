#include "apps/print_prediction.h"

#include <fmt/format.h>

#include "base/units.h"

namespace thenar {
namespace {

std::vector<double> list(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

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

const char* in_words(PredictedBy by) {
  if (by == PredictedBy::kOwn) return "was fitted; its own parameters predict";
  if (by == PredictedBy::kOwnPopulation)
    return "was fitted; the population, of which it is a part, predicts";
  return "was never fitted; the population predicts";
}

}  // namespace

PredictedBy predicted_by(int specimen, bool population) {
  if (specimen < 0) return PredictedBy::kStranger;
  return population ? PredictedBy::kOwnPopulation : PredictedBy::kOwn;
}

nlohmann::json prediction_json(const Prediction& prediction, const std::string& specimen,
                               PredictedBy by) {
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
          {"specimen_was_fitted", by != PredictedBy::kStranger},
          {"predicted_by", by == PredictedBy::kOwn ? "own parameters" : "population"},
          {"start_has_seen_specimen", prediction.calibrated_on_specimen},
          {"rms_error_N", prediction.error.rms},
          {"relative_error", prediction.error.relative},
          {"relative_error_flexion_plane", prediction.error.relative_flexion},
          {"direction_error_deg", degrees(prediction.error.direction)},
          {"covered_95",
           prediction.error.covered ? nlohmann::json(*prediction.error.covered) : nlohmann::json()},
          {"vectors", vectors}};
}

void print_prediction(const Prediction& prediction, const Experiment& experiment, PredictedBy by) {
  fmt::print("{}: specimen {} {}\n", prediction.experiment, experiment.specimen, in_words(by));
  if (prediction.calibrated_on_specimen)
    fmt::print("  the subject that the fit started from has seen this specimen\n");
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

}  // namespace thenar
