#include "kinematics_fit/experiment_warnings.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "tendons/posture_slopes.h"

namespace thenar {
namespace {

constexpr double kBeyond = 5 * kDegree;  // limits are of other hands: some slack [rad]
constexpr double kTooStrong = 2;         // tension per largest force beyond any living muscle [1]

using Warnings = std::vector<std::string>;

void warn_of_postures(const TendonDigit& digit, const ExperimentPlan& plan, Warnings& warnings) {
  for (std::size_t k = 0; k < plan.postures.size(); ++k) {
    if (plan.condition[k] > kNearlyStraight)
      warnings.push_back(
          fmt::format("posture '{}' is nearly singular (condition {:.3g}): its forces hang on "
                      "angles that nobody can measure well enough",
                      plan.posture_names[k], plan.condition[k]));
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
    double most = 0;
    for (const Eigen::VectorXd& tension : plan.tension) most = std::max(most, tension[m]);
    if (most > kTooStrong * digit.max_tension[m])
      warnings.push_back(fmt::format("{} was pulled with {:.1f} N, but can make {:.1f} N",
                                     digit.names.muscles[static_cast<std::size_t>(m)], most,
                                     digit.max_tension[m]));
  }
}

void warn_of_calibration(const TendonDigit& digit, const Experiment& experiment,
                         Warnings& warnings) {
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
  Warnings warnings;
  warn_of_postures(digit, plan, warnings);
  warn_of_tensions(digit, plan, warnings);
  warn_of_calibration(digit, experiment, warnings);
  const auto moments = std::count_if(experiment.trials.begin(), experiment.trials.end(),
                                     [](const Trial& trial) { return trial.moment.has_value(); });
  if (moments > 0)
    warnings.push_back(
        fmt::format("{} measured moments are not fitted, only the forces are", moments));
  for (std::string& warning : warnings)
    warning = fmt::format("experiment '{}': {}", experiment.name, warning);
  return warnings;
}

}  // namespace thenar
