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

/// The same, and the dorsal places of the flexors' path points.
inline const std::string kAxesAndPaths = kAxes + R"(
[[parameter]]
match = "path/FD?/*/dorsal"
state = "free"
sd_mm = 0.7
between_sd_mm = 0.9
)";

/// Settings that free the friction of the deep flexor, bounded to both sides.
inline const std::string kFriction = R"(
[[parameter]]
match = "friction/FDP"
state = "free"
mean = 0.1
sd = 0.05
between_sd = 0.08
lower = 0
upper = 0.5
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

/// A digit whose axes may move and tilt; degrees of directions are not lengths of points.
inline FitSetup moving_axes(const std::string& points) {
  return middle_finger(R"([[parameter]]
match = "axis/MCP3_*/direction/*"
state = "free"
sd_deg = 6
between_sd_deg = 5
[[parameter]]
match = ")" + points + R"("
state = "free"
sd_mm = 2
between_sd_mm = 1
range_mm = 30
)");
}

/// Standard normal numbers.
inline Eigen::VectorXd normal(Eigen::Index size, std::mt19937& rng) {
  std::normal_distribution<double> one;
  return Eigen::VectorXd::NullaryExpr(size, [&] { return one(rng); });
}

/// Prior sds of the population's coordinates [SI] (coordinates).
inline Eigen::VectorXd population_sds(const FitParameters& parameters) {
  Eigen::VectorXd sd(parameters.coordinates());
  for (int c = 0; c < parameters.coordinates(); ++c)
    sd[c] = parameters.all[parameters.leader[c]].sd;
  return sd;
}

/// Prior sds of a specimen about its population [SI] (coordinates).
inline Eigen::VectorXd between_sds(const FitParameters& parameters) {
  Eigen::VectorXd sd(parameters.coordinates());
  for (int c = 0; c < parameters.coordinates(); ++c)
    sd[c] = parameters.all[parameters.leader[c]].between_sd;
  return sd;
}

/// A person's displacements, drawn from the prior about a population [SI] (coordinates).
inline Eigen::VectorXd draw_person(const FitParameters& parameters,
                                   const Eigen::VectorXd& population, std::mt19937& rng) {
  const Eigen::VectorXd sd = between_sds(parameters);
  return population + sd.cwiseProduct(normal(sd.size(), rng));
}

/// The fit from the prior means, to the last digits.
inline Solution fit_precisely(const FitProblem& problem) {
  SolveOptions options;
  options.tolerance = 1e-14;
  return solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()), options);
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
