#include "studies/thumb/thumb_experiment.h"

#include <array>
#include <cmath>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/random_stream.h"
#include "base/units.h"
#include "kinematics_fit/force_jacobian.h"

namespace thenar {
namespace {

constexpr std::uint32_t kDigitizingStream = 201;  // Purpose of the random stream of noise

/// Degrees at CMC flexion and abduction, MCP flexion and abduction, IP.
PostureRecord posture(const char* name, std::array<double, 5> degrees) {
  constexpr const char* kJoints[] = {"CMC1_FE", "CMC1_AA", "MCP1_FE", "MCP1_AA", "IP1"};
  PostureRecord record{name, {}};
  for (std::size_t j = 0; j < degrees.size(); ++j) record.angles[kJoints[j]] = radians(degrees[j]);
  return record;
}

std::string list(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

std::string table(const std::map<std::string, double>& values) {
  std::vector<std::string> parts;
  parts.reserve(values.size());
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

std::vector<PostureRecord> thumb_postures() {
  return {posture("key", {0, -10, 20, 0, 30}), posture("opposition", {-15, 15, 15, 5, 20}),
          posture("wide", {-30, 20, 0, -5, 40}), posture("hook", {5, 0, 30, 0, 55})};
}

Eigen::Matrix3Xd true_forces(const TendonDigit& truth, const Experiment& experiment) {
  const FitParameters parameters = choose_parameters(truth, {}, {});
  return force_values(truth, parameters, plan_experiment(truth, parameters, experiment),
                      Eigen::VectorXd());
}

Experiment simulate_pulls(const TendonDigit& truth, const SimulatedPullOptions& options) {
  // The protocol: a pinned tip in the first postures.
  const std::vector<PostureRecord> postures = thumb_postures();
  require(options.postures >= 1 && options.postures <= static_cast<int>(postures.size()),
          "there are 1 to {} postures, asked for {}", postures.size(), options.postures);
  Experiment experiment;
  experiment.name = "pulls";
  experiment.specimen = "made_up_thumb";
  experiment.species = "human";
  experiment.source = "made up";
  experiment.digit = "thumb";
  experiment.hold = TipConstraint::kPinned;
  experiment.force_segment = "DP1";
  experiment.postures.assign(postures.begin(), postures.begin() + options.postures);
  // One muscle after the other in every posture.
  for (const PostureRecord& record : experiment.postures)
    for (const std::string& muscle : truth.names.muscles) {
      Trial trial;
      trial.posture = record.name;
      trial.tension = {{muscle, options.tension}};
      trial.sd = Eigen::Vector3d::Constant(options.floor);
      experiment.trials.push_back(trial);
    }
  // True forces, their sds, and noise if it is wanted.
  const Eigen::Matrix3Xd force = true_forces(truth, experiment);
  for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
    Trial& trial = experiment.trials[i];
    trial.force = force.col(static_cast<Eigen::Index>(i));
    const double sd = std::hypot(options.floor, options.noise * trial.force.norm());
    trial.sd = Eigen::Vector3d::Constant(sd);
    RandomStream random(options.seed, static_cast<std::uint32_t>(i), 0, kDigitizingStream);
    for (int k = 0; k < 3 && options.add_noise; ++k) trial.force[k] += sd * random.normal();
  }
  return experiment;
}

std::string experiment_text(const Experiment& experiment) {
  // Head of the file.
  require(experiment.axes_of_digit == Eigen::Matrix3i::Identity(),
          "forces of '{}' are not along proximal, dorsal and radial", experiment.name);
  std::string text = fmt::format(
      "name = \"{}\"\nspecimen = \"{}\"\nspecies = \"{}\"\ndescription = \"{}\"\n"
      "source = \"judgement\"\ndigit = \"{}\"\n\n[sources]\njudgement = \"Made up: {}\"\n\n"
      "[protocol]\nhold = \"{}\"\n\n[force]\nsegment = \"{}\"\n"
      "components = [\"proximal\", \"dorsal\", \"radial\"]\n",
      experiment.name, experiment.specimen, experiment.species, experiment.description,
      experiment.digit, experiment.source, name_in(kTipConstraintNames, experiment.hold),
      experiment.force_segment);
  // Postures, trials and rows of activations.
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
