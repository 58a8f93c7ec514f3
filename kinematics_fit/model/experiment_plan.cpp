#include "kinematics_fit/model/experiment_plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>
#include <Eigen/SVD>

#include "base/error.h"
#include "base/lists.h"
#include "base/units.h"
#include "kinematics_fit/model/force_site.h"
#include "kinematics_fit/model/net_trials.h"
#include "tendons/forces/posture_sensitivity.h"

namespace thenar {
namespace {

// Tolerance on joint limits, which were measured on other hands [rad]
constexpr double kLimitSlack = 5 * kDegree;
// Largest plausible tension over a muscle's maximum force; no living muscle exceeds it [1]
constexpr double kMaxStrengthRatio = 2;

using Warnings = std::vector<std::string>;

void warn_of_postures(const TendonDigit& digit, const ExperimentPlan& plan, Warnings& warnings) {
  for (std::size_t k = 0; k < plan.postures.size(); ++k) {
    // Warn of nearly straight postures, in which small angle errors change the forces much.
    if (plan.condition[k] > kNearlyStraight)
      warnings.push_back(
          fmt::format("posture '{}' is nearly singular (condition {:.3g}): its forces hang on "
                      "angles that nobody can measure well enough",
                      plan.posture_names[k], plan.condition[k]));
    // Warn of angles beyond the joint limits.
    for (int j = 0; j < digit.skeleton.coordinates(); ++j) {
      const CoordinateLimits& limits = digit.skeleton.limits[j];
      const double angle = plan.postures[k][j];
      if (angle < limits.lower - kLimitSlack || angle > limits.upper + kLimitSlack)
        warnings.push_back(
            fmt::format("posture '{}': {} = {:.1f} deg is beyond {:.1f} .. {:.1f} deg",
                        plan.posture_names[k], digit.skeleton.coordinate_names[j], degrees(angle),
                        degrees(limits.lower), degrees(limits.upper)));
    }
  }
}

/// Warns of angles that may be in radians under a key in degrees: all are tiny, and not all are 0.
void warn_of_angle_units(const Experiment& experiment, Warnings& warnings) {
  constexpr double kTinyAngle = 3.2 * kDegree;  // 180 degrees in radians, read as degrees [rad]
  double largest = 0;
  for (const PostureRecord& posture : experiment.postures)
    for (const auto& [joint, angle] : posture.angles) largest = std::max(largest, std::abs(angle));
  if (largest > 0 && largest < kTinyAngle)
    warnings.push_back(
        fmt::format("no joint is turned by more than {:.3g} degrees in any posture: are the angles "
                    "of the unit that their key names?",
                    degrees(largest)));
}

void warn_of_tensions(const TendonDigit& digit, const ExperimentPlan& plan, Warnings& warnings) {
  for (Eigen::Index m = 0; m < digit.max_tension.size(); ++m) {
    // Find the largest tension of the muscle over all trials.
    double largest = 0;
    for (const Eigen::VectorXd& tension : plan.tension) largest = std::max(largest, tension[m]);
    if (largest > kMaxStrengthRatio * digit.max_tension[m])
      warnings.push_back(fmt::format("{} was pulled with {:.1f} N, but can make {:.1f} N",
                                     digit.names.muscles[m], largest, digit.max_tension[m]));
  }
}

/// Warns of a pinned tip whose two forces cannot balance the torques of more than two joints in a
/// plane.
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

/// Warns of forces on segments that few joints move, which torques alone do not determine.
void warn_of_sites(const ExperimentPlan& plan, const Experiment& experiment, Warnings& warnings) {
  const int loads = (plan.known == DecidedForces::kInPlane ? 2 : 3) +
                    (plan.hold == TipConstraint::kRigid ? 1 : 0);
  std::vector<bool> warned(plan.sites.size(), false);
  for (std::size_t i = 0; i < plan.site_of_trial.size(); ++i) {
    // Check each site once, except mounts.
    const auto at = static_cast<std::size_t>(plan.site_of_trial[i]);
    if (plan.site_of_trial[i] < 0 || warned[at]) continue;
    warned[at] = true;
    const PlannedSite& site = plan.sites[at];
    if (site.link >= 0 && static_cast<int>(site.balanced.size()) < loads)
      warnings.push_back(fmt::format(
          "a load cell at {} carries {} loads, but {} joint angles move that segment: forces are "
          "those of least norm, as torques do not tell how bones and cell share them",
          experiment.trials[i].site->at, loads, site.balanced.size()));
  }
}

void warn_of_calibration(const TendonDigit& digit, const Experiment& experiment,
                         Warnings& warnings) {
  // List the calibrations that used this specimen.
  std::string names;
  for (const CalibratedOn& on : digit.calibrated_on)
    if (has_seen({on}, experiment))
      names += (names.empty() ? "" : ", ") +
               (on.source.empty() ? "'" + on.experiment + "'" : "all specimens of " + on.source);
  if (!names.empty())
    warnings.push_back(fmt::format(
        "the subject has seen specimen {}: it was calibrated on {}. Errors of its "
        "forces, even left-out ones, do not show how well unseen specimens are predicted",
        experiment.specimen, names));
}

}  // namespace

std::vector<std::string> experiment_warnings(const TendonDigit& digit, const ExperimentPlan& plan,
                                             const Experiment& experiment) {
  // Check postures, tensions, constraint and calibration.
  Warnings warnings;
  warn_of_angle_units(experiment, warnings);
  warn_of_postures(digit, plan, warnings);
  warn_of_tensions(digit, plan, warnings);
  warn_of_hold(digit, plan, warnings);
  warn_of_sites(plan, experiment, warnings);
  warn_of_calibration(digit, experiment, warnings);

  // Warn of data that the fit does not use.
  const auto moments = std::count_if(experiment.trials.begin(), experiment.trials.end(),
                                     [](const Trial& trial) { return trial.moment.has_value(); });
  if (moments > 0)
    warnings.push_back(
        fmt::format("{} measured moments are not fitted, only the forces are", moments));

  // Prefix each warning with its experiment.
  for (std::string& warning : warnings)
    warning = fmt::format("experiment '{}': {}", experiment.name, warning);
  return warnings;
}

namespace {

// Condition number above which no digit of a force is right [1]
constexpr double kSingularCondition = 1e12;
// Largest angle between an axis and the normal of its plane [rad]
constexpr double kNormalAngle = 15 * kDegree;
constexpr double kNoAngle =
    1e-6;  // largest angle between axes that are parallel up to rounding [rad]

/// Returns whether all axes between the tip and the base are normal to the plane of flexion, to
/// within `angle` [rad].
bool all_flex(const TendonModel<double>& digit, double angle) {
  bool all = true;
  for_each_hinge_to_base(digit.tree, digit.tip_link, [&](int i) {
    const Eigen::Vector3d d = digit.tree[i].direction.normalized();
    all = all && std::abs(d.dot(digit.tip_axes.col(2))) >= std::cos(angle);
  });
  return all;
}

/// Describes why a singular posture does not determine the forces, and a remedy.
std::string singular_in_words(const TendonDigit& digit, const ExperimentPlan& plan) {
  if (plan.known == DecidedForces::kInPlane)
    return "the held tip carries forces in the plane of flexion that no joint feels; leave it out";
  if (all_flex(digit.model, kNoAngle))
    return "all axes are parallel, so that no joint feels a force across their plane; fit the two "
           "components in the plane: not_modelled = \"radial\" in [force]";
  return "the held tip carries loads that no joint feels; leave it out";
}

Eigen::VectorXd tensions(const TendonDigit& digit, const Trial& trial) {
  // Set the stated tensions; muscles that a trial does not name are slack.
  Eigen::VectorXd t = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(digit.names.muscles.size()));
  for (const auto& [muscle, tension] : trial.tension) t[muscle_index(digit, muscle)] = tension;
  return t;
}

int posture_index(const ExperimentPlan& plan, const std::string& name) {
  const int found = place_in(plan.posture_names, name);
  require(found >= 0, "trial names posture '{}', which is not defined", name);
  return found;
}

int link_named(const TendonDigit& digit, const Experiment& experiment, const std::string& segment) {
  const auto link = digit.skeleton.link_of_segment.find(segment);
  require(link != digit.skeleton.link_of_segment.end(),
          "experiment '{}' states forces in segment '{}', which the digit has not", experiment.name,
          segment);
  return link->second;
}

/// Returns the point at a fraction of the bone of a link, which extends from the point of its own
/// joint to that of the next one, or to the tip [m] (3).
Eigen::Vector3d along_bone(const TendonModel<double>& digit, int link, double fraction) {
  Eigen::Vector3d end = digit.tip;
  for_each_hinge_to_base(digit.tree, digit.tip_link, [&](int i) {
    if (i > link && (digit.tree[i].point - digit.tree[link].point).norm() > 1e-6)
      end = digit.tree[i].point;
  });
  return digit.tree[link].point + fraction * (end - digit.tree[link].point);
}

/// Returns the place on the constrained segment, at the reference posture [m] (3).
Eigen::Vector3d held_point(const TendonModel<double>& digit, const ForceSite& site, int link) {
  if (site.point) return *site.point;
  if (!site.fraction && link == digit.tip_link) return digit.tip;
  return along_bone(digit, link, site.fraction.value_or(0.5));
}

/// Resolves the segments of a site, which is the mount of a digit or a segment between base and
/// tip.
PlannedSite plan_site(const TendonDigit& digit, const Experiment& experiment,
                      const ForceSite& site) {
  const TendonModel<double>& model = digit.model;
  PlannedSite plan{link_named(digit, experiment, site.at),
                   Eigen::Vector3d::Zero(),
                   link_named(digit, experiment, site.axes),
                   site.leave,
                   {}};
  if (plan.link < 0) {
    // Check that a mount's force can be computed from the directions in which all tendons leave.
    require(!site.point && !site.fraction,
            "experiment '{}': '{}' is the mount, whose force has no place 'at_mm' or 'at_fraction'",
            experiment.name, site.at);
    for (std::size_t m = 0; m < model.pulls.size(); ++m)
      require(!model.paths[model.pulls[m]].empty(),
              "experiment '{}': the force on mount '{}' needs the paths of all tendons; {} has "
              "only moment arms",
              experiment.name, site.at, digit.names.muscles[m]);
    return plan;
  }
  plan.point = held_point(model, site, plan.link);
  // List the coordinates that move the segment.
  std::vector<bool> moves(static_cast<std::size_t>(model.coordinates), false);
  for_each_hinge_to_base(model.tree, plan.link,
                         [&](int i) { moves[model.tree[i].coordinate] = true; });
  for (int j = 0; j < model.coordinates; ++j)
    if (moves[j]) plan.balanced.push_back(j);
  return plan;
}

/// Returns the index of a trial's site in the plan, and adds it if it is new; -1 for the tip.
int site_index(const TendonDigit& digit, const Experiment& experiment, std::size_t trial,
               ExperimentPlan& plan) {
  const std::optional<ForceSite>& site = experiment.trials[trial].site;
  if (!site) return -1;
  require(!digit.net,
          "experiment '{}': a net is fitted to forces of the tip alone; leave out trials "
          "measured at other segments",
          experiment.name);
  for (std::size_t i = 0; i < trial; ++i)
    if (experiment.trials[i].site == site) return plan.site_of_trial[i];
  plan.sites.push_back(plan_site(digit, experiment, *site));
  return static_cast<int>(plan.sites.size()) - 1;
}

/// Returns whether the tip is constrained in a posture, as by default and while a mount is
/// measured.
bool holds_tip(const ExperimentPlan& plan, int posture) {
  bool any = false;
  for (std::size_t i = 0; i < plan.posture_of_trial.size(); ++i) {
    if (plan.posture_of_trial[i] != posture) continue;
    any = true;
    const int at = site_of(plan, i);
    if (at < 0 || plan.sites[at].link < 0) return true;
  }
  return !any;
}

double condition_of(const Eigen::MatrixXd& loads) {
  const Eigen::VectorXd sigma = loads.jacobiSvd().singularValues();
  return sigma[0] / sigma[sigma.size() - 1];
}

/// Returns the largest condition number of the constraint loads in each posture, with all
/// parameters at their prior means.
std::vector<double> conditions(const TendonDigit& digit, const FitParameters& parameters,
                               const ExperimentPlan& plan) {
  // Build the digit at the prior means.
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(parameters.coordinates());
  const SpecimenModel<double> model =
      specimen_model(digit, parameters, parameter_values<double>(parameters, u));
  // Compute the ratio of the extreme singular values of the loads in each posture.
  std::vector<double> conditions;
  for (std::size_t k = 0; k < plan.postures.size(); ++k) {
    const TreeState<double> state =
        pose_tree(model.digit.tree, Eigen::VectorXd(plan.postures[k] + model.angle_error));
    double worst = holds_tip(plan, static_cast<int>(k))
                       ? condition_of(tip_constraint_loads(model.digit, state, plan.hold,
                                                           plan.known, model.out_of_plane))
                       : 1;
    for (std::size_t i = 0; i < plan.site_of_trial.size(); ++i) {
      const int at = plan.site_of_trial[i];
      if (plan.posture_of_trial[i] != static_cast<int>(k) || at < 0) continue;
      const PlannedSite& site = plan.sites[at];
      if (site.link >= 0)
        worst = std::max(
            worst, condition_of(segment_loads(model.digit, site, state, plan.hold, plan.known)));
    }
    conditions.push_back(worst);
  }
  return conditions;
}

}  // namespace

int muscle_index(const TendonDigit& digit, const std::string& name) {
  const int found = place_in(digit.names.muscles, name);
  require(found >= 0, "no muscle '{}' pulls on this digit; there are {}", name,
          fmt::join(digit.names.muscles, ", "));
  return found;
}

ExperimentPlan plan_experiment(const TendonDigit& digit, const FitParameters& parameters,
                               const Experiment& experiment) {
  // Check that the experiment is of this digit.
  const std::string& built = digit.skeleton.tips.front().digit;
  require(experiment.digit == built, "experiment '{}' is of the {}, but the digit built is the {}",
          experiment.name, experiment.digit, built);

  // Set the tip constraint, and the axes of the forces.
  ExperimentPlan plan;
  plan.hold = experiment.hold;
  plan.force_link = link_named(digit, experiment, experiment.force_segment);
  plan.measured = experiment.components;
  plan.components = experiment.axes_of_digit.cast<double>();
  if (plan.measured == 2 && all_flex(digit.model, kNormalAngle))
    plan.known = DecidedForces::kInPlane;

  // Resolve the postures, and their keys among the parameters.
  for (const PostureRecord& record : experiment.postures) {
    plan.postures.push_back(posture(digit.skeleton, record.angles));
    plan.posture_names.push_back(record.name);
    plan.posture_key.push_back(place_in(parameters.postures, record.name));
  }

  // Resolve posture, site and tensions of each trial.
  for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
    plan.posture_of_trial.push_back(posture_index(plan, experiment.trials[i].posture));
    plan.site_of_trial.push_back(site_index(digit, experiment, i, plan));
    plan.tension.push_back(tensions(digit, experiment.trials[i]));
  }

  // Reject singular postures, in which torques do not determine the forces.
  plan.condition = conditions(digit, parameters, plan);
  for (std::size_t k = 0; k < plan.postures.size(); ++k)
    require(plan.condition[k] < kSingularCondition,
            "posture '{}' of experiment '{}' is singular: {}", plan.posture_names[k],
            experiment.name, singular_in_words(digit, plan));

  // Set the measured forces, and their sds with the model error included.
  plan.force.resize(3, static_cast<Eigen::Index>(experiment.trials.size()));
  plan.sd.resize(3, plan.force.cols());
  for (Eigen::Index i = 0; i < plan.force.cols(); ++i) {
    const Trial& trial = experiment.trials[i];
    plan.force.col(i) = trial.force;
    const double missed = missed_force_sd(parameters, trial.tension);
    plan.sd.col(i) =
        (force_sd(experiment, trial).array().square() + missed * missed).sqrt().matrix();
  }
  if (digit.net) plan.net_start = net_starts(digit, parameters, plan);
  return plan;
}

}  // namespace thenar
