#include "kinematics_fit/prediction.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "kinematics_fit/model/shared_postures.h"
#include "kinematics_fit/predictive_moments.h"
#include "kinematics_fit/specimen_prior.h"

namespace thenar {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// Returns -log N(r; 0, sd^2) [nat].
double normal_loss(double r, double sd) {
  constexpr double kHalfLogTwoPi = 0.91893853320467274;
  return kHalfLogTwoPi + std::log(sd) + 0.5 * (r / sd) * (r / sd);
}

/// Returns whether each posture has its own parameter of this kind.
bool of_one_posture(const Parameter& p) {
  return p.kind == ParameterKind::kPostureAngle || p.kind == ParameterKind::kPostureForce;
}

/// Belief about such a parameter in a posture: the mean over known postures.
struct PostureBelief {
  double mean = 0;      // [SI]
  double variance = 0;  // [SI^2]
};

/// Returns the belief about a parameter of a further posture. @param like  parameter of one of the
/// postures
PostureBelief posture_belief(const FitParameters& fitted, const Parameter& like) {
  // Sum means and variances over the postures.
  PostureBelief sum;
  for (std::size_t p = 0; p < fitted.all.size(); ++p) {
    const Parameter& one = fitted.all[p];
    if (one.kind != like.kind || one.item != like.item || one.component != like.component) continue;
    sum.mean += one.mean;
    if (fitted.coordinate[p] < 0) continue;
    const Parameter& leader = fitted.all[fitted.leader[fitted.coordinate[p]]];
    sum.variance +=
        std::pow(fitted.ratio[p], 2) * (std::pow(leader.sd, 2) + std::pow(leader.between_sd, 2));
  }
  const auto postures = static_cast<double>(fitted.postures.size());
  return {sum.mean / postures, sum.variance / postures};
}

}  // namespace

Eigen::Matrix3Xd predict_trials(const FitProblem& problem, const Eigen::VectorXd& z, int e) {
  require(z.size() == problem.size(), "fit has {} coordinates, got {}", problem.size(), z.size());
  require(z.allFinite(), "coordinates of a fit must be finite");
  const int specimen = problem.specimen_of(e);
  return force_values(problem.digit_of(specimen), problem.parameters(), problem.plans()[e],
                      displacements(problem.coordinates(), z, specimen), problem.kernel_of(e));
}

FitParameters add_posture_errors(FitParameters fitted, const Experiment& experiment) {
  const FitParameters known = fitted;
  // Give each posture that the fit does not know its own key.
  for (const PostureRecord& posture : experiment.postures) {
    const auto& names = fitted.postures;
    if (known.postures.empty() || contains(names, posture.name)) continue;
    const auto key = static_cast<int>(names.size());
    fitted.postures.push_back(posture.name);
    // Copy the parameters of the first known posture, with the mean of the priors of all postures.
    for (const Parameter& like : known.all) {
      if (!of_one_posture(like) || like.point != 0) continue;
      const PostureBelief belief = posture_belief(known, like);
      Parameter p = like;
      p.name = like.name.substr(0, like.name.rfind('/') + 1) + posture.name;
      p.point = key;
      p.lower += belief.mean - p.mean;
      p.upper += belief.mean - p.mean;
      p.mean = belief.mean;
      p.sd = 0;
      p.between_sd = std::sqrt(belief.variance);
      fitted.coordinate.push_back(belief.variance > 0 ? fitted.coordinates() : -1);
      fitted.ratio.push_back(1);
      fitted.scale.push_back(-1);
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
  return trial.site ? loads + " at " + trial.site->at : loads;
}

bool calibrated_on_specimen(const TendonDigit& digit, const Experiment& experiment) {
  return has_seen(digit.calibrated_on, experiment);
}

Prediction compare_forces(const Experiment& experiment, const Eigen::Matrix3Xd& predicted,
                          const Eigen::Matrix3Xd& sd, bool calibrated_on_specimen) {
  Prediction out{experiment.name, {}, {}, calibrated_on_specimen};
  for (Eigen::Index i = 0; i < predicted.cols(); ++i) {
    // Compare trial by trial.
    const Trial& trial = experiment.trials[i];
    out.trials.push_back({trial.posture, describe_loads(trial), trial.force, predicted.col(i),
                          sd.col(i), experiment.components});
  }
  if (!out.trials.empty()) out.error = force_error(out.trials);
  return out;
}

ForceError force_error(const std::vector<PredictedTrial>& trials) {
  require(!trials.empty(), "an error needs at least one trial");
  double residual = 0, flexion = 0, total = 0, total_flexion = 0;
  int covered = 0, counted = 0;
  double log_loss = 0;
  std::vector<double> angles;
  // Sum squares of all components, and of the two in the plane of flexion.
  for (const PredictedTrial& trial : trials) {
    const Eigen::Vector3d r = trial.predicted - trial.measured;
    residual += r.squaredNorm();
    flexion += r.head<2>().squaredNorm();
    total += trial.measured.squaredNorm();
    total_flexion += trial.measured.head<2>().squaredNorm();
    // Collect angles and coverage, where they are defined.
    if (trial.predicted.squaredNorm() > 0 && trial.measured.squaredNorm() > 0)
      angles.push_back(direction_error(trial));
    if (trial.sd.minCoeff() <= 0) continue;
    const auto inside = r.array().abs() <= 1.96 * trial.sd.array();
    covered += static_cast<int>(inside.head(trial.components).count());
    counted += trial.components;
    for (int c = 0; c < trial.components; ++c) log_loss += normal_loss(r[c], trial.sd[c]);
  }
  require(total > 0, "all {} measured forces are zero: an error relative to them is not defined",
          trials.size());

  // Divide the sums.
  ForceError error;
  error.rms = std::sqrt(residual / static_cast<double>(trials.size()));
  error.relative = std::sqrt(residual / total);
  error.relative_flexion = std::sqrt(flexion / total_flexion);
  error.direction = median(std::move(angles));
  if (counted > 0) {
    error.covered = static_cast<double>(covered) / counted;
    error.log_loss = log_loss / counted;
  }
  error.trials = static_cast<int>(trials.size());
  return error;
}

Prediction predict_fitted(const FitProblem& problem, const Eigen::VectorXd& z, int e) {
  const Experiment& experiment = problem.experiments()[e];
  const Eigen::Matrix3Xd force = predict_trials(problem, z, e);
  return compare_forces(experiment, force, Eigen::Matrix3Xd::Zero(3, force.cols()),
                        calibrated_on_specimen(problem.digit(), experiment));
}

Prediction predict_experiment(const FitProblem& fitted, const Eigen::VectorXd& z,
                              const ArrowMatrix& C, const Experiment& experiment, int specimen) {
  // Plan the trials, with parameters for postures that the fit does not know.
  const Experiment named = with_own_postures(experiment, fitted.experiments());
  const FitParameters parameters = add_posture_errors(fitted.parameters(), named);
  const int known = fitted.parameters().coordinates(), all = parameters.coordinates();
  const TendonDigit digit = fitted.sized_digit(experiment);
  const ExperimentPlan plan = plan_experiment(digit, parameters, named);

  // Compute the displacements of the specimen, or of the population.
  Eigen::VectorXd u = Eigen::VectorXd::Zero(all);
  u.head(known) = displacements(fitted.coordinates(), z, specimen);

  // Add the variances of the estimate, of an unseen specimen's deviation, and of unknown postures.
  const Eigen::MatrixXd J_z = displacement_jacobian(fitted.coordinates(), z, specimen);
  Eigen::MatrixXd V = Eigen::MatrixXd::Zero(all, all);
  V.topLeftCorner(known, known) = J_z * C.block_entries(specimen) * J_z.transpose();
  if (specimen < 0) V.diagonal().head(known) += unseen_variance(fitted.coordinates());
  for (int c = known; c < all; ++c)
    V(c, c) = std::pow(parameters.all[parameters.leader[c]].between_sd, 2);

  // Compute mean forces, and their variance with the noise.
  const PredictiveMoments moments = predictive_moments(digit, parameters, plan, u, V);
  const Eigen::VectorXd sd =
      (moments.variance + plan.sd.reshaped().cwiseAbs2().matrix()).cwiseSqrt();
  Prediction out =
      compare_forces(experiment, moments.mean,
                     Eigen::Map<const Eigen::Matrix3Xd>(sd.data(), 3, moments.mean.cols()),
                     calibrated_on_specimen(fitted.digit(), experiment));
  for (std::size_t i = 0; i < out.trials.size(); ++i) out.trials[i].by_draws = moments.by_draws[i];
  return out;
}

std::vector<std::string> unsteady_force_warnings(const Prediction& prediction) {
  const auto unsteady = [](const PredictedTrial& trial) { return trial.by_draws; };
  const auto& trials = prediction.trials;
  const auto first = std::find_if(trials.begin(), trials.end(), unsteady);
  if (first == trials.end()) return {};
  return {
      fmt::format("experiment '{}': predicted forces of {} of {} trials, first under {} in "
                  "posture '{}', hang on angles and axes by more than these are known: they "
                  "are medians of draws, and their sds tell how far off they may be",
                  prediction.experiment, std::count_if(first, trials.end(), unsteady),
                  trials.size(), first->loads, first->posture)};
}

int find_specimen(const FitProblem& fitted, const std::string& specimen) {
  static_assert(kUnfittedSpecimen == -1, "place_in() returns it for an absent specimen");
  return place_in(fitted.specimens(), specimen);
}

}  // namespace thenar
