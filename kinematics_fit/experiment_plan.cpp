#include "kinematics_fit/experiment_plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>
#include <Eigen/SVD>

#include "base/error.h"
#include "base/units.h"
#include "kinematics_fit/net_trials.h"
#include "tendons/forces/posture_sensitivity.h"

namespace thenar {
namespace {

constexpr double kBeyond = 5 * kDegree;  // limits are of other hands: some slack [rad]
constexpr double kTooStrong = 2;         // tension per largest force beyond any living muscle [1]

using Warnings = std::vector<std::string>;

void warn_of_postures(const TendonDigit& digit, const ExperimentPlan& plan, Warnings& warnings) {
  for (std::size_t k = 0; k < plan.postures.size(); ++k) {
    // Nearly straight: small errors of angles change the forces much.
    if (plan.condition[k] > kNearlyStraight)
      warnings.push_back(
          fmt::format("posture '{}' is nearly singular (condition {:.3g}): its forces hang on "
                      "angles that nobody can measure well enough",
                      plan.posture_names[k], plan.condition[k]));
    // Angles beyond the joint limits.
    for (int j = 0; j < digit.skeleton.coordinates(); ++j) {
      const CoordinateLimits& limits = digit.skeleton.limits[static_cast<std::size_t>(j)];
      const double angle = plan.postures[k][j];
      if (angle < limits.lower - kBeyond || angle > limits.upper + kBeyond)
        warnings.push_back(
            fmt::format("posture '{}': {} = {:.1f} deg is beyond {:.1f} .. {:.1f} deg",
                        plan.posture_names[k], digit.skeleton.coordinate_names[j], degrees(angle),
                        degrees(limits.lower), degrees(limits.upper)));
    }
  }
}

void warn_of_tensions(const TendonDigit& digit, const ExperimentPlan& plan, Warnings& warnings) {
  for (Eigen::Index m = 0; m < digit.max_tension.size(); ++m) {
    // Largest tension of the muscle over all trials.
    double most = 0;
    for (const Eigen::VectorXd& tension : plan.tension) most = std::max(most, tension[m]);
    if (most > kTooStrong * digit.max_tension[m])
      warnings.push_back(fmt::format("{} was pulled with {:.1f} N, but can make {:.1f} N",
                                     digit.names.muscles[static_cast<std::size_t>(m)], most,
                                     digit.max_tension[m]));
  }
}

/// Two forces of a pinned tip cannot balance the torques of more joints in their plane.
void warn_of_hold(const TendonDigit& digit, const ExperimentPlan& plan, Warnings& warnings) {
  const int joints = digit.model.coordinates;
  if (plan.hold != TipConstraint::kPinned || plan.known != DecidedForces::kInPlane || joints <= 2)
    return;
  warnings.push_back(fmt::format(
      "a pinned tip of a finger with {} joints in one plane leaves torque that nothing balances, "
      "so that forces are those of least squares: was the tip clamped (hold = \"rigid\"), or a "
      "joint splinted?",
      joints));
}

void warn_of_calibration(const TendonDigit& digit, const Experiment& experiment,
                         Warnings& warnings) {
  // Calibrations that used this specimen.
  std::string names;
  for (const CalibratedOn& on : digit.calibrated_on)
    if (has_seen({on}, experiment.name, experiment.specimen))
      names += (names.empty() ? "'" : ", '") + on.experiment + "'";
  if (!names.empty())
    warnings.push_back(
        fmt::format("the subject has seen specimen {}: it was calibrated on {}. Errors of its "
                    "forces, also left out, do not tell how well strangers are predicted",
                    experiment.specimen, names));
}

}  // namespace

std::vector<std::string> experiment_warnings(const TendonDigit& digit, const ExperimentPlan& plan,
                                             const Experiment& experiment) {
  // Postures, tensions, hold and calibration.
  Warnings warnings;
  warn_of_postures(digit, plan, warnings);
  warn_of_tensions(digit, plan, warnings);
  warn_of_hold(digit, plan, warnings);
  warn_of_calibration(digit, experiment, warnings);

  // Data that no fit uses.
  const auto moments = std::count_if(experiment.trials.begin(), experiment.trials.end(),
                                     [](const Trial& trial) { return trial.moment.has_value(); });
  if (moments > 0)
    warnings.push_back(
        fmt::format("{} measured moments are not fitted, only the forces are", moments));

  // All name their experiment.
  for (std::string& warning : warnings)
    warning = fmt::format("experiment '{}': {}", experiment.name, warning);
  return warnings;
}

namespace {

constexpr double kSingular = 1e12;  // condition beyond which no digit of a force is right [1]
constexpr double kParallel = 15 * kDegree;  // of axes with the normal of their plane [rad]
constexpr double kNoAngle = 1e-6;           // the same, of parallel axes up to rounding [rad]

/// Do all axes between the tip and the base stand on the plane of flexion, to within `angle` [rad]?
bool all_flex(const TendonModel<double>& digit, double angle) {
  bool all = true;
  for_each_hinge_to_base(digit.tree, digit.tip_link, [&](int i) {
    const Eigen::Vector3d d = digit.tree[i].direction.normalized();
    all = all && std::abs(d.dot(digit.tip_axes.col(2))) >= std::cos(angle);
  });
  return all;
}

/// Why no force follows in a singular posture, and what to do.
std::string singular_in_words(const TendonDigit& digit, const ExperimentPlan& plan) {
  if (plan.known == DecidedForces::kInPlane)
    return "the held tip carries forces in the plane of flexion that no joint feels; leave it out";
  if (all_flex(digit.model, kNoAngle))
    return "all axes are parallel, so that no joint feels a force across their plane; fit the two "
           "components in the plane: not_modelled = \"radial\" in [force]";
  return "the held tip carries loads that no joint feels; leave it out";
}

Eigen::VectorXd tensions(const TendonDigit& digit, const Trial& trial) {
  // Muscles that a trial does not name are slack.
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
  // The digit at the prior means.
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(parameters.coordinates());
  const SpecimenModel<double> model =
      specimen_model(digit, parameters, parameter_values<double>(parameters, u));
  // Ratio of the extreme singular values of the loads in each posture.
  std::vector<double> conditions;
  for (const Eigen::VectorXd& q : plan.postures) {
    const Eigen::VectorXd sigma =
        tip_constraint_loads(model.digit,
                             pose_tree(model.digit.tree, Eigen::VectorXd(q + model.angle_error)),
                             plan.hold, plan.known, model.out_of_plane)
            .jacobiSvd()
            .singularValues();
    conditions.push_back(sigma[0] / sigma[sigma.size() - 1]);
  }
  return conditions;
}

}  // namespace

ExperimentPlan plan_experiment(const TendonDigit& digit, const FitParameters& parameters,
                               const Experiment& experiment) {
  // Does the experiment fit the digit?
  const std::string& built = digit.skeleton.tips.front().digit;
  require(experiment.digit == built, "experiment '{}' is of the {}, but the digit built is the {}",
          experiment.name, experiment.digit, built);
  const auto link = digit.skeleton.link_of_segment.find(experiment.force_segment);
  require(link != digit.skeleton.link_of_segment.end(),
          "experiment '{}' states forces in segment '{}', which the digit has not", experiment.name,
          experiment.force_segment);

  // How the tip is held, and in which axes forces are stated.
  ExperimentPlan plan;
  plan.hold = experiment.hold;
  plan.force_link = link->second;
  plan.measured = experiment.components;
  plan.components = experiment.axes_of_digit.cast<double>();
  if (plan.measured == 2 && all_flex(digit.model, kParallel)) plan.known = DecidedForces::kInPlane;

  // Postures, and the angle errors that belong to them.
  for (const PostureRecord& record : experiment.postures) {
    plan.postures.push_back(posture(digit.skeleton, record.angles));
    plan.posture_names.push_back(record.name);
    const auto& known = parameters.postures;
    const auto key = std::find(known.begin(), known.end(), record.name);
    plan.posture_key.push_back(key == known.end() ? -1 : static_cast<int>(key - known.begin()));
  }

  // No force follows from the tendons' torques in a singular posture.
  plan.condition = conditions(digit, parameters, plan);
  for (std::size_t k = 0; k < plan.postures.size(); ++k)
    require(plan.condition[k] < kSingular, "posture '{}' of experiment '{}' is singular: {}",
            plan.posture_names[k], experiment.name, singular_in_words(digit, plan));

  // Trials: posture, tensions, measured force, and its sd with that of what the model misses.
  plan.force.resize(3, static_cast<Eigen::Index>(experiment.trials.size()));
  plan.sd.resize(3, plan.force.cols());
  for (Eigen::Index i = 0; i < plan.force.cols(); ++i) {
    const Trial& trial = experiment.trials[i];
    plan.posture_of_trial.push_back(posture_index(plan, trial.posture));
    plan.tension.push_back(tensions(digit, trial));
    plan.force.col(i) = trial.force;
    const Eigen::VectorXd& t = plan.tension.back();
    const bool several = (t.array() > 0).count() > 1;
    const double missed =
        t.sum() * std::hypot(parameters.misfit, several ? parameters.superposition : 0);
    plan.sd.col(i) =
        (force_sd(experiment, trial).array().square() + missed * missed).sqrt().matrix();
  }
  if (digit.net) plan.net_start = net_starts(digit, parameters, plan);
  return plan;
}

}  // namespace thenar
