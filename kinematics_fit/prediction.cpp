#include "kinematics_fit/prediction.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "kinematics_fit/force_jacobian.h"
#include "kinematics_fit/specimen_prior.h"

namespace thenar {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// What is believed of the angle error of a joint in a posture, as the mean over known postures.
struct AngleBelief {
  double mean = 0;      // [rad]
  double variance = 0;  // [rad^2]
};

AngleBelief angle_belief(const FitParameters& fitted, int joint) {
  // Means and variances of this joint's error, over the postures that have one.
  AngleBelief sum;
  for (std::size_t p = 0; p < fitted.all.size(); ++p) {
    if (fitted.all[p].kind != ParameterKind::kPostureAngle || fitted.all[p].item != joint) continue;
    sum.mean += fitted.all[p].mean;
    if (fitted.coordinate[p] < 0) continue;
    const Parameter& leader = fitted.all[fitted.leader[fitted.coordinate[p]]];
    sum.variance +=
        std::pow(fitted.ratio[p], 2) * (std::pow(leader.sd, 2) + std::pow(leader.between_sd, 2));
  }
  const auto postures = static_cast<double>(fitted.postures.size());
  return {sum.mean / postures, sum.variance / postures};
}

}  // namespace

TrialPrediction predict_trials(const FitProblem& problem, const Eigen::VectorXd& z, int e,
                               WithJacobian want) {
  require(z.size() == problem.size(), "fit has {} coordinates, got {}", problem.size(), z.size());
  require(z.allFinite(), "coordinates of a fit must be finite");
  // Displacements of the specimen, then forces with or without slopes.
  const int specimen = problem.specimen_of(e);
  const ExperimentPlan& plan = problem.plans()[e];
  const Eigen::VectorXd u = displacements(problem.coordinates(), z, specimen);
  if (want == WithJacobian::kNo)
    return {force_values(problem.digit(), problem.parameters(), plan, u), {}};
  ForceJacobian forces = force_jacobian(problem.digit(), problem.parameters(), plan, u);
  return {std::move(forces.force),
          forces.J * displacement_jacobian(problem.coordinates(), z, specimen)};
}

FitParameters add_posture_errors(FitParameters fitted, const Experiment& experiment, int joints) {
  const FitParameters known = fitted;
  if (known.postures.empty()) return fitted;
  // A posture that the fit does not name gets its own key.
  for (const PostureRecord& posture : experiment.postures) {
    const auto& names = fitted.postures;
    if (std::find(names.begin(), names.end(), posture.name) != names.end()) continue;
    const auto key = static_cast<int>(names.size());
    fitted.postures.push_back(posture.name);
    // Every joint errs there by the mean prior of known postures.
    for (int joint = 0; joint < joints; ++joint) {
      const AngleBelief belief = angle_belief(known, joint);
      Parameter p;
      p.name = "angle of " + posture.name;
      p.kind = ParameterKind::kPostureAngle;
      p.item = joint;
      p.point = key;
      p.mean = belief.mean;
      p.between_sd = std::sqrt(belief.variance);
      fitted.coordinate.push_back(belief.variance > 0 ? fitted.coordinates() : -1);
      fitted.ratio.push_back(1);
      if (belief.variance > 0) fitted.leader.push_back(static_cast<int>(fitted.all.size()));
      fitted.all.push_back(std::move(p));
    }
  }
  return fitted;
}

double direction_error(const PredictedTrial& trial) {
  return std::atan2(trial.predicted.cross(trial.measured).norm(),
                    trial.predicted.dot(trial.measured));
}

std::string describe_loads(const Trial& trial) {
  std::string loads;
  for (const auto& [muscle, tension] : trial.tension)
    if (tension > 0) loads += (loads.empty() ? "" : "+") + muscle;
  return loads;
}

bool calibrated_on_specimen(const TendonDigit& digit, const Experiment& experiment) {
  return has_seen(digit.calibrated_on, experiment.name, experiment.specimen);
}

Prediction compare_forces(const Experiment& experiment, const Eigen::Matrix3Xd& predicted,
                          const Eigen::Matrix3Xd& sd, bool calibrated_on_specimen) {
  Prediction out{experiment.name, {}, {}, calibrated_on_specimen};
  for (Eigen::Index i = 0; i < predicted.cols(); ++i) {
    // Predicted and measured, trial by trial.
    const Trial& trial = experiment.trials[i];
    out.trials.push_back({trial.posture, describe_loads(trial), trial.force, predicted.col(i),
                          sd.col(i), experiment.components});
  }
  out.error = force_error(out.trials);
  return out;
}

ForceError force_error(const std::vector<PredictedTrial>& trials) {
  require(!trials.empty(), "an error needs at least one trial");
  double residual = 0, flexion = 0, total = 0, total_flexion = 0;
  int covered = 0, counted = 0;
  std::vector<double> angles;
  // Sums of squares, all components and the two in the plane of flexion.
  for (const PredictedTrial& trial : trials) {
    const Eigen::Vector3d r = trial.predicted - trial.measured;
    residual += r.squaredNorm();
    flexion += r.head<2>().squaredNorm();
    total += trial.measured.squaredNorm();
    total_flexion += trial.measured.head<2>().squaredNorm();
    // Angles and coverage, where they are defined.
    if (trial.predicted.squaredNorm() > 0 && trial.measured.squaredNorm() > 0)
      angles.push_back(direction_error(trial));
    if (trial.sd.minCoeff() <= 0) continue;
    const auto inside = r.array().abs() <= 1.96 * trial.sd.array();
    covered += static_cast<int>(inside.head(trial.components).count());
    counted += trial.components;
  }
  require(total > 0, "all {} measured forces are zero: an error relative to them is not defined",
          trials.size());

  // Ratios of the sums.
  ForceError error;
  error.rms = std::sqrt(residual / static_cast<double>(trials.size()));
  error.relative = std::sqrt(residual / total);
  error.relative_flexion = std::sqrt(flexion / total_flexion);
  error.direction = median(std::move(angles));
  if (counted > 0) error.covered = static_cast<double>(covered) / counted;
  error.trials = static_cast<int>(trials.size());
  return error;
}

Prediction predict_fitted(const FitProblem& problem, const Eigen::VectorXd& z, int e) {
  const Experiment& experiment = problem.experiments()[e];
  const Eigen::Matrix3Xd force = predict_trials(problem, z, e, WithJacobian::kNo).force;
  return compare_forces(experiment, force, Eigen::Matrix3Xd::Zero(3, force.cols()),
                        calibrated_on_specimen(problem.digit(), experiment));
}

Prediction predict_experiment(const FitProblem& fitted, const Eigen::VectorXd& z,
                              const ArrowMatrix& C, const Experiment& experiment, int specimen) {
  // Parameters and plan, with errors of postures that the fit does not know.
  const FitParameters parameters =
      add_posture_errors(fitted.parameters(), experiment, fitted.digit().model.coordinates);
  const int known = fitted.parameters().coordinates();
  const ExperimentPlan plan = plan_experiment(fitted.digit(), parameters, experiment);

  // Forces of the specimen, or of the population.
  Eigen::VectorXd u = Eigen::VectorXd::Zero(parameters.coordinates());
  u.head(known) = displacements(fitted.coordinates(), z, specimen);
  const ForceJacobian forces = force_jacobian(fitted.digit(), parameters, plan, u);

  // Variance of the estimate, and of the deviation of an unseen specimen.
  const std::vector<int> on = fitted.coordinates().entries_of_specimen(specimen);
  const Eigen::MatrixXd J_z =
      forces.J.leftCols(known) *
      displacement_jacobian(fitted.coordinates(), z, specimen)(Eigen::all, on);
  Eigen::VectorXd variance = (J_z * C.of(specimen)).cwiseProduct(J_z).rowwise().sum();
  if (specimen < 0)
    variance += forces.J.leftCols(known).cwiseAbs2() * unseen_variance(fitted.coordinates());
  // Variance of unknown errors of angles, and the noise.
  for (int c = known; c < parameters.coordinates(); ++c)
    variance +=
        forces.J.col(c).cwiseAbs2() * std::pow(parameters.all[parameters.leader[c]].between_sd, 2);
  variance += Eigen::Map<const Eigen::VectorXd>(plan.sd.data(), plan.sd.size()).cwiseAbs2();
  const Eigen::VectorXd sd = variance.cwiseSqrt();
  return compare_forces(experiment, forces.force,
                        Eigen::Map<const Eigen::Matrix3Xd>(sd.data(), 3, forces.force.cols()),
                        calibrated_on_specimen(fitted.digit(), experiment));
}

int find_specimen(const FitProblem& fitted, const std::string& specimen) {
  const auto& known = fitted.specimens();
  const auto found = std::find(known.begin(), known.end(), specimen);
  return found == known.end() ? kUnfittedSpecimen : static_cast<int>(found - known.begin());
}

}  // namespace thenar
