#pragma once

/// Fits for tests: the published ones from data/, and small made-up ones.

#include <random>
#include <string>
#include <vector>

#include "data/io/toml_node.h"
#include "kinematics_fit/cross_validation.h"
#include "kinematics_fit/fit.h"
#include "kinematics_fit/fit_residuals.h"
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

/// A finger of three parallel axes with two flexors and one extensor; x proximal, y dorsal.
inline const std::string kPlanarFinger = R"(name = "planar"
side = "right"
base = "MC2"
source = "Mine"
[sources]
Mine = "made up"
[[segment]]
name = "MC2"
[[segment]]
name = "PP2"
[[segment]]
name = "MP2"
[[segment]]
name = "DP2"
[[joint]]
name = "MCP2_FE"
parent = "MC2"
child = "PP2"
direction = [0, 0, 1]
point_mm = [90, 0, 0]
[[joint]]
name = "PIP2"
parent = "PP2"
child = "MP2"
direction = [0, 0, 1]
point_mm = [45, 0, 0]
[[joint]]
name = "DIP2"
parent = "MP2"
child = "DP2"
direction = [0, 0, 1]
point_mm = [20, 0, 0]
[[strand]]
name = "FDP"
path = [{segment = "DP2", point_mm = [14, -4, 0]}, {segment = "MP2", point_mm = [28, -5, 0]},
        {segment = "MP2", point_mm = [40, -6, 0]}, {segment = "PP2", point_mm = [54, -7, 0]},
        {segment = "PP2", point_mm = [80, -9, 0]}, {segment = "MC2", point_mm = [98, -10, 0]}]
[[strand]]
name = "FDS"
path = [{segment = "MP2", point_mm = [38, -6, 0]}, {segment = "PP2", point_mm = [55, -8, 0]},
        {segment = "PP2", point_mm = [80, -10, 0]}, {segment = "MC2", point_mm = [98, -12, 0]}]
[[muscle]]
name = "FDP"
[[muscle]]
name = "FDS"
[[digit]]
name = "index"
tip_segment = "DP2"
tip_mm = [0, -4, 0]
proximal = [1, 0, 0]
dorsal = [0, 1, 0]
)";

/// Forces of that finger in its plane.
/// @param force  the table [force] without its segment;  @param first  forces of the first row;
/// @param second  and of the second
inline std::string planar_trials(const std::string& force, const std::string& first,
                                 const std::string& second) {
  return R"(name = "planar_forces"
digit = "index"
source = "Mine"
[sources]
Mine = "made up"
[protocol]
hold = "pinned"
[noise]
floor_N = 0.05
[force]
segment = "DP2"
)" + force +
         R"(
[[posture]]
name = "bent"
angles_deg = {MCP2_FE = 30, PIP2 = 45, DIP2 = 20}
[[posture]]
name = "hook"
angles_deg = {MCP2_FE = 10, PIP2 = 70, DIP2 = 40}
[trials]
rows = [
  {posture = "bent", tension_N = {FDP = 10}, force_N = )" +
         first + R"(},
  {posture = "hook", tension_N = {FDS = 8, FDP = 3}, force_N = )" +
         second + R"(},
]
)";
}

/// The planar finger on two components, its tendon paths free.
inline FitSetup planar_finger(
    const std::string& trials = planar_trials("components = ['proximal', 'dorsal']", "[-0.6, -1.2]",
                                              "[-0.9, -1]")) {
  FitSetup setup{build_tendon_digit(parse_subject(kPlanarFinger, "planar.toml"), "index"), {}, {}};
  setup.experiments = {parse_experiment(trials, "trials.toml")};
  setup.parameters =
      choose_parameters(setup.digit, postures_of(setup.experiments.front()), settings(R"(
[[parameter]]
match = "path/FD?/*/dorsal"
state = "free"
sd_mm = 0.7
between_sd_mm = 0.9
)"));
  return setup;
}

/// The planar finger, known by its moment arms and not by points.
inline std::string planar_finger_of_arms() {
  const std::string text = kPlanarFinger;
  const std::size_t begin = text.find("[[strand]]"), end = text.find("[[muscle]]");
  return text.substr(0, begin) +
         "[[strand]]\nname = 'FDP'\narms_mm = {MCP2_FE = 10, PIP2 = 8, DIP2 = 4}\n"
         "[[strand]]\nname = 'FDS'\narms_mm = {MCP2_FE = 12, PIP2 = 7.5}\n" +
         text.substr(end);
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

/// Prior sds of a person about the prior means [SI] (coordinates).
inline Eigen::VectorXd person_sds(const FitParameters& parameters) {
  return (population_sds(parameters).cwiseAbs2() + between_sds(parameters).cwiseAbs2()).cwiseSqrt();
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

/// The fit of as many specimens as wanted: copies of H01 and H02 in turn, with noise of their own,
/// a tenth of each force and 0.15 N.
inline FitProblem noisy_copies(int count) {
  const FitProblem two = build_problem(finger_inputs("an_chao_middle", {"H01", "H02"}));
  std::mt19937 rng(1);
  std::vector<Experiment> copies;
  for (int k = 0; k < count; ++k) {
    copies.push_back(two.experiments()[static_cast<std::size_t>(k % 2)]);
    copies.back().name = copies.back().specimen = "copy" + std::to_string(k);
    for (Trial& trial : copies.back().trials)
      trial.force +=
          (0.1 * trial.force.norm() / std::sqrt(3.0) + 0.15) * Eigen::Vector3d(normal(3, rng));
  }
  return {two.digit(), two.parameters(), std::move(copies), two.robust_scale()};
}

}  // namespace thenar::sample
