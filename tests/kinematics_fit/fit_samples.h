#pragma once

/// Fits for tests: the published ones from data/, and small made-up ones.

#include <random>
#include <string>
#include <vector>

#include "data/io/toml_node.h"
#include "kinematics_fit/cross_validation.h"
#include "kinematics_fit/fit.h"
#include "kinematics_fit/force_jacobian.h"
#include "kinematics_fit/specimen_prior.h"

namespace thenar::sample {

/// A file of data/: source("subjects/an_chao_middle").
inline SourceText source(const std::string& name) {
  const std::string path = std::string(THENAR_DATA_DIR) + "/" + name + ".toml";
  return {path, read_text_file(path)};
}

/// The built-in finger settings on one subject and any of the measured fingers.
inline FitInputs finger_inputs(const std::string& subject,
                               const std::vector<std::string>& specimens) {
  FitInputs inputs{source("subjects/" + subject), source("fits/finger"), {}, {}};
  for (const std::string& specimen : specimens)
    inputs.experiments.push_back(source("experiments/synek2019_" + specimen));
  return inputs;
}

inline Experiment experiment(const std::string& specimen) {
  const SourceText text = source("experiments/synek2019_" + specimen);
  return parse_experiment(text.text, text.path);
}

/// Settings written in a test; the first line of `rows` is line 2.
inline FitSettings settings(const std::string& rows) {
  return parse_fit_settings("source = 'Synek2019'\n" + rows, "fit.toml");
}

/// Settings that free the directions of all axes.
inline const std::string kAxes = R"(
[[parameter]]
match = "axis/*/direction/*"
state = "free"
sd_deg = 3
between_sd_deg = 4
)";

/// One digit with some parameters free and the experiments it is fitted to.
struct FitSetup {
  TendonDigit digit;
  FitParameters parameters;
  std::vector<Experiment> experiments;

  [[nodiscard]] FitProblem problem(double robust_scale = 0) const {
    return {digit, parameters, experiments, robust_scale};
  }
};

inline std::vector<std::string> postures_of(const Experiment& experiment) {
  std::vector<std::string> names;
  for (const PostureRecord& posture : experiment.postures) names.push_back(posture.name);
  return names;
}

/// The published middle finger on one measured specimen with settings written in the test.
inline FitSetup middle_finger(const std::string& rows, const std::string& specimen = "H01",
                              const std::string& subject = "synek2019_middle") {
  const SourceText text = source("subjects/" + subject);
  FitSetup setup{build_tendon_digit(parse_subject(text.text, text.path), "middle"), {}, {}};
  setup.experiments = {experiment(specimen)};
  setup.parameters =
      choose_parameters(setup.digit, postures_of(setup.experiments.front()), settings(rows));
  return setup;
}

/// Standard normal numbers.
inline Eigen::VectorXd normal(Eigen::Index size, std::mt19937& rng) {
  std::normal_distribution<double> one;
  return Eigen::VectorXd::NullaryExpr(size, [&] { return one(rng); });
}

/// Writes the forces that the digit makes for displacements u, with noise, into an experiment.
inline void simulate(const FitSetup& setup, const Eigen::VectorXd& u, double noise,
                     std::mt19937& rng, Experiment& experiment) {
  const Eigen::Matrix3Xd force = force_values(
      setup.digit, setup.parameters, plan_experiment(setup.digit, setup.parameters, experiment), u);
  for (std::size_t i = 0; i < experiment.trials.size(); ++i)
    experiment.trials[i].force =
        force.col(static_cast<Eigen::Index>(i)) + noise * Eigen::Vector3d(normal(3, rng));
}

}  // namespace thenar::sample
