#include "kinematics_fit/fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "base/error.h"

namespace thenar {
namespace internal {
const std::map<std::string, std::string_view>& fit_settings();  // data/fits, by file name
}

namespace {

/// Names of the postures of all experiments, each once.
std::vector<std::string> posture_names(const std::vector<Experiment>& experiments) {
  std::vector<std::string> names;
  for (const Experiment& experiment : experiments)
    for (const PostureRecord& posture : experiment.postures)
      if (std::find(names.begin(), names.end(), posture.name) == names.end())
        names.push_back(posture.name);
  return names;
}

}  // namespace

SourceText built_in_settings(const std::string& digit) {
  const std::string name = digit == "thumb" ? "thumb.toml" : "finger.toml";
  return {"built-in " + name, std::string(internal::fit_settings().at(name))};
}

FitProblem build_problem(const FitInputs& inputs) {
  require(!inputs.experiments.empty(), "a fit needs at least one experiment");
  std::vector<Experiment> experiments;
  for (const SourceText& source : inputs.experiments)
    experiments.push_back(parse_experiment(source.text, source.path));
  for (const Experiment& experiment : experiments)
    require(experiment.digit == experiments.front().digit,
            "experiments are of different digits: '{}' of the {}, '{}' of the {}",
            experiments.front().name, experiments.front().digit, experiment.name, experiment.digit);

  for (std::size_t e = 0; e < experiments.size(); ++e)
    for (std::size_t other = 0; other < e; ++other)
      require(experiments[e].name != experiments[other].name,
              "experiment '{}' is given twice: it would count twice", experiments[e].name);

  const Subject subject = parse_subject(inputs.subject.text, inputs.subject.path);
  TendonDigit digit = build_tendon_digit(subject, experiments.front().digit);
  const FitSettings settings = parse_fit_settings(inputs.settings.text, inputs.settings.path);
  FitParameters parameters =
      choose_parameters(digit, posture_names(experiments), settings, inputs.also_free);
  return {std::move(digit), std::move(parameters), std::move(experiments), settings.robust_scale,
          settings.axis_distances};
}

Fit run_fit(const FitInputs& inputs, const SolveOptions& options) {
  FitProblem problem = build_problem(inputs);
  Solution solution = solve(least_squares(problem), Eigen::VectorXd::Zero(problem.size()), options);
  Covariance covariance = posterior_covariance(problem, solution.z);
  return {inputs,       std::move(problem),  options.method,
          options.seed, std::move(solution), std::move(covariance)};
}

FittedValues fitted_values(const Fit& fit, int specimen) {
  const FitParameters& parameters = fit.problem.parameters();
  const std::vector<double> values =
      parameter_values<double>(parameters, fit.problem.displacements(fit.solution.z, specimen));
  const std::vector<int> on = fit.problem.entries_of_specimen(specimen);
  const Eigen::MatrixXd J =
      fit.problem.displacement_jacobian(fit.solution.z, specimen)(Eigen::all, on);
  Eigen::VectorXd variance = (J * fit.covariance.C(on, on)).cwiseProduct(J).rowwise().sum();
  // What one specimen alone cannot say of the population stays as wide as the prior has it.
  const Eigen::VectorXd unseen = fit.problem.unseen_variance();
  if (specimen < 0)
    for (int c = 0; c < parameters.coordinates(); ++c) {
      const Parameter& p = parameters.all[static_cast<std::size_t>(parameters.leader[c])];
      variance[c] += unseen[c] - p.between_sd * p.between_sd;
    }
  FittedValues out{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(values.size())),
                   Eigen::VectorXd::Zero(static_cast<Eigen::Index>(values.size()))};
  for (Eigen::Index p = 0; p < out.value.size(); ++p) {
    const auto at = static_cast<std::size_t>(p);
    const double scale = display_scale(parameters.all[at]);
    out.value[p] = values[at] * scale;
    if (parameters.coordinate[at] >= 0)
      out.sd[p] = std::abs(parameters.ratio[at]) *
                  std::sqrt(std::max(0.0, variance[parameters.coordinate[at]])) * scale;
  }
  return out;
}

}  // namespace thenar
