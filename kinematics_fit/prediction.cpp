#include "kinematics_fit/prediction.h"

#include <algorithm>
#include <cmath>

#include "kinematics_fit/force_jacobian.h"

namespace thenar {
namespace {

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::string describe_loads(const Trial& trial) {
  std::string loads;
  for (const auto& [muscle, tension] : trial.tension)
    if (tension > 0) loads += (loads.empty() ? "" : "+") + muscle;
  return loads;
}

Prediction compare(const Experiment& experiment, const Eigen::Matrix3Xd& predicted,
                   const Eigen::Matrix3Xd& sd) {
  Prediction out{experiment.name, {}, {}};
  for (Eigen::Index i = 0; i < predicted.cols(); ++i) {
    const Trial& trial = experiment.trials[i];
    out.trials.push_back(
        {trial.posture, describe_loads(trial), trial.force, predicted.col(i), sd.col(i)});
  }
  out.error = force_error(out.trials);
  return out;
}

ForceError force_error(const std::vector<PredictedTrial>& trials) {
  double residual = 0, flexion = 0, total = 0, total_flexion = 0;
  int covered = 0, counted = 0;
  std::vector<double> angles;
  for (const PredictedTrial& trial : trials) {
    const Eigen::Vector3d r = trial.predicted - trial.measured;
    residual += r.squaredNorm();
    flexion += r.head<2>().squaredNorm();
    total += trial.measured.squaredNorm();
    total_flexion += trial.measured.head<2>().squaredNorm();
    angles.push_back(angle_between(trial.predicted, trial.measured));
    if (trial.sd.minCoeff() <= 0) continue;
    covered += static_cast<int>((r.array().abs() <= 1.96 * trial.sd.array()).count());
    counted += 3;
  }
  const auto count = static_cast<double>(trials.size());
  return {count > 0 ? std::sqrt(residual / count) : 0, std::sqrt(residual / total),
          std::sqrt(flexion / total_flexion), median(std::move(angles)),
          counted > 0 ? static_cast<double>(covered) / counted : 0};
}

Prediction predict_fitted(const FitProblem& problem, const Eigen::VectorXd& z, int e) {
  const Eigen::Matrix3Xd force = problem.predict(z, e, WithJacobian::kNo).force;
  return compare(problem.experiments()[e], force, Eigen::Matrix3Xd::Zero(3, force.cols()));
}

Prediction predict_experiment(const FitProblem& fitted, const Eigen::VectorXd& z,
                              const Eigen::MatrixXd& C, const Experiment& experiment,
                              int specimen) {
  const ExperimentPlan plan = plan_experiment(fitted.digit(), fitted.parameters(), experiment);
  const ForceJacobian forces =
      force_jacobian(fitted.digit(), fitted.parameters(), plan, fitted.displacements(z, specimen));
  const Eigen::MatrixXd J_z = forces.J * fitted.displacement_jacobian(specimen);
  Eigen::VectorXd variance = (J_z * C).cwiseProduct(J_z).rowwise().sum();
  if (specimen < 0) variance += forces.J.cwiseAbs2() * fitted.unseen_variance();
  variance += Eigen::Map<const Eigen::VectorXd>(plan.sd.data(), plan.sd.size()).cwiseAbs2();
  const Eigen::VectorXd sd = variance.cwiseSqrt();
  return compare(experiment, forces.force,
                 Eigen::Map<const Eigen::Matrix3Xd>(sd.data(), 3, forces.force.cols()));
}

int find_specimen(const FitProblem& fitted, const std::string& specimen) {
  const auto& known = fitted.specimens();
  const auto found = std::find(known.begin(), known.end(), specimen);
  return found == known.end() ? -1 : static_cast<int>(found - known.begin());
}

}  // namespace thenar
