#include "kinematics_fit/predict_forces.h"

#include <algorithm>

#include <fmt/ranges.h>
#include <Eigen/SVD>

namespace thenar {
namespace {

constexpr double kSingular = 1e12;  // condition beyond which no digit of a force is right [1]

Eigen::VectorXd tensions(const TendonDigit& digit, const Trial& trial) {
  const std::vector<std::string>& names = digit.names.muscles;
  Eigen::VectorXd t = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(names.size()));
  for (const auto& [muscle, tension] : trial.tension) {
    const auto found = std::find(names.begin(), names.end(), muscle);
    require(found != names.end(), "no muscle '{}' pulls on this digit; there are {}", muscle,
            fmt::join(names, ", "));
    t[found - names.begin()] = tension;
  }
  return t;
}

int posture_index(const ExperimentPlan& plan, const std::string& name) {
  const auto& names = plan.posture_names;
  const auto found = std::find(names.begin(), names.end(), name);
  require(found != names.end(), "trial names posture '{}', which is not defined", name);
  return static_cast<int>(found - names.begin());
}

/// Condition of the loads of every posture, with all parameters at their prior means.
std::vector<double> conditions(const TendonDigit& digit, const FitParameters& parameters,
                               const ExperimentPlan& plan) {
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(parameters.coordinates());
  const SpecimenModel<double> model =
      specimen_model(digit, parameters, parameter_values<double>(parameters, u));
  std::vector<double> conditions;
  for (const Eigen::VectorXd& q : plan.postures) {
    const Eigen::VectorXd sigma =
        held_loads(model.digit, pose_tree(model.digit.tree, Eigen::VectorXd(q + model.angle_error)),
                   plan.hold, model.out_of_plane)
            .jacobiSvd()
            .singularValues();
    conditions.push_back(sigma[0] / sigma[sigma.size() - 1]);
  }
  return conditions;
}

}  // namespace

ExperimentPlan plan_experiment(const TendonDigit& digit, const FitParameters& parameters,
                               const Experiment& experiment) {
  const std::string& built = digit.skeleton.tips.front().digit;
  require(experiment.digit == built, "experiment '{}' is of the {}, but the digit built is the {}",
          experiment.name, experiment.digit, built);
  const auto link = digit.skeleton.link_of_segment.find(experiment.force_segment);
  require(link != digit.skeleton.link_of_segment.end(),
          "experiment '{}' states forces in segment '{}', which the digit has not", experiment.name,
          experiment.force_segment);
  ExperimentPlan plan;
  plan.hold = experiment.hold;
  plan.force_link = link->second;
  plan.components = experiment.axes_of_digit.cast<double>();
  for (const PostureRecord& record : experiment.postures) {
    plan.postures.push_back(posture(digit.skeleton, record.angles));
    plan.posture_names.push_back(record.name);
    const auto& known = parameters.postures;
    const auto key = std::find(known.begin(), known.end(), record.name);
    plan.posture_key.push_back(key == known.end() ? -1 : static_cast<int>(key - known.begin()));
  }
  plan.condition = conditions(digit, parameters, plan);
  for (std::size_t k = 0; k < plan.postures.size(); ++k)
    require(plan.condition[k] < kSingular,
            "posture '{}' of experiment '{}' is singular: the held tip carries loads that no joint "
            "feels; leave it out",
            plan.posture_names[k], experiment.name);
  plan.force.resize(3, static_cast<Eigen::Index>(experiment.trials.size()));
  plan.sd.resize(3, plan.force.cols());
  for (Eigen::Index i = 0; i < plan.force.cols(); ++i) {
    const Trial& trial = experiment.trials[i];
    plan.posture_of_trial.push_back(posture_index(plan, trial.posture));
    plan.tension.push_back(tensions(digit, trial));
    plan.force.col(i) = trial.force;
    plan.sd.col(i) = force_sd(experiment, trial);
  }
  return plan;
}

}  // namespace thenar
