#include <fmt/ranges.h>

#include "base/error.h"
#include "posterior/study/thumb_experiment.h"

namespace thenar {
namespace {

std::string list(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

std::string table(const std::map<std::string, double>& values) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : values) parts.push_back(fmt::format("{} = {}", name, value));
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

std::string row_of(const Trial& trial, const std::string& experiment) {
  require(trial.sd.has_value(), "a trial of '{}' in posture '{}' has no sd", experiment,
          trial.posture);
  return fmt::format("  {{posture = \"{}\", tension_N = {}, force_N = {}, sd_N = {}}},\n",
                     trial.posture, table(trial.tension), list(trial.force), list(*trial.sd));
}

std::string activation_of(const ActivationRow& row, const std::string& experiment) {
  require(row.force_sd.has_value() && !row.sd.empty(),
          "a row of activations of '{}' in posture '{}' has no sd", experiment, row.posture);
  return fmt::format(
      "\n[[activation]]\nposture = \"{}\"\nactivation = {}\nactivation_sd = {}\n"
      "activation_sd_of = {}\nforce_N = {}\nsd_N = {}\n",
      row.posture, table(row.activation), row.sd.begin()->second, table(row.sd), list(row.force),
      list(*row.force_sd));
}

}  // namespace

std::string experiment_text(const Experiment& experiment) {
  require(experiment.axes_of_digit == Eigen::Matrix3i::Identity(),
          "forces of '{}' are not along proximal, dorsal and radial", experiment.name);
  std::string text = fmt::format(
      "name = \"{}\"\nspecimen = \"{}\"\nspecies = \"{}\"\ndescription = \"{}\"\n"
      "source = \"judgement\"\ndigit = \"{}\"\n\n[sources]\njudgement = \"Made up: {}\"\n\n"
      "[protocol]\nhold = \"{}\"\n\n[force]\nsegment = \"{}\"\n"
      "components = [\"proximal\", \"dorsal\", \"radial\"]\n",
      experiment.name, experiment.specimen, experiment.species, experiment.description,
      experiment.digit, experiment.source, experiment.hold == TipHold::kPinned ? "pinned" : "rigid",
      experiment.force_segment);
  for (const PostureRecord& posture : experiment.postures)
    text += fmt::format("\n[[posture]]\nname = \"{}\"\nangles_rad = {}\n", posture.name,
                        table(posture.angles));
  if (!experiment.trials.empty()) {
    text += "\n[trials]\nrows = [\n";
    for (const Trial& trial : experiment.trials) text += row_of(trial, experiment.name);
    text += "]\n";
  }
  for (const ActivationRow& row : experiment.activations)
    text += activation_of(row, experiment.name);
  return text;
}

}  // namespace thenar
