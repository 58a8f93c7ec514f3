#include "kinematics_fit/odd_trials.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "base/special_functions.h"
#include "kinematics_fit/fit_residuals.h"
#include "kinematics_fit/prediction.h"

namespace thenar {
namespace {

constexpr double kOdd = 1e-3;  // tail probability of an odd trial [1]

/// The residual of a trial of which a robust loss of scale c made r.
Eigen::Vector3d plain_residual(const Eigen::Vector3d& r, double c) {
  const double squared = r.squaredNorm();
  if (c <= 0 || squared == 0) return r;
  return r * std::sqrt(c * c * std::expm1(squared / (c * c)) / squared);
}

/// Squared distance of a trial from what all others tell of it, see odd_trials() [1].
double squared_distance(const Eigen::Vector3d& r, const Eigen::MatrixXd& J,
                        const Eigen::MatrixXd& C) {
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - J * C * J.transpose();
  return r.dot(rest.llt().solve(r));
}

}  // namespace

std::vector<OddTrial> odd_trials(const FitProblem& problem, const Eigen::VectorXd& z,
                                 const Covariance& covariance) {
  std::vector<OddTrial> odd;
  double trials = 0;
  for (const ExperimentPlan& plan : problem.plans()) trials += static_cast<double>(plan.sd.cols());
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e) {
    const ExperimentPlan& plan = problem.plans()[static_cast<std::size_t>(e)];
    const Residuals data = data_residuals(problem, z, e, WithJacobian::kYes);
    const Eigen::MatrixXd C = covariance.C.of(problem.specimen_of(e));
    for (Eigen::Index i = 0; i < plan.sd.cols(); ++i) {
      // Residuals that are not fitted are 0, and so are their slopes.
      const Eigen::Vector3d r = plain_residual(data.r.segment<3>(3 * i), problem.robust_scale());
      const double squared = squared_distance(r, data.J.middleRows<3>(3 * i), C);
      const auto fitted = static_cast<double>((plan.sd.col(i).array() < HUGE_VAL).count());
      const double tail = std::min(1.0, trials * chi_square_tail(squared, fitted));
      if (!(tail >= kOdd)) odd.push_back({e, static_cast<int>(i), std::sqrt(squared), tail});
    }
  }
  std::sort(odd.begin(), odd.end(),
            [](const OddTrial& a, const OddTrial& b) { return a.distance > b.distance; });
  return odd;
}

std::vector<std::string> describe(const FitProblem& problem, const std::vector<OddTrial>& odd) {
  constexpr int kNamed = 3;  // of an experiment; the others are counted
  std::vector<std::string> warnings;
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e) {
    const Experiment& experiment = problem.experiments()[static_cast<std::size_t>(e)];
    // The oddest by name.
    std::string names;
    int found = 0;
    for (const OddTrial& each : odd) {
      if (each.experiment != e || ++found > kNamed) continue;
      const Trial& trial = experiment.trials[static_cast<std::size_t>(each.trial)];
      names += fmt::format("{}{} in posture '{}' ({:.1f} sds)", found > 1 ? ", " : "",
                           describe_loads(trial), trial.posture, each.distance);
    }
    if (found == 0) continue;
    if (found > kNamed) names += fmt::format(" and {} more", found - kNamed);
    warnings.push_back(fmt::format(
        "experiment '{}': forces are far from what all other trials tell of them: {}. Is a row "
        "turned, of another load or posture, or in another unit? One such row can move all that is "
        "fitted",
        experiment.name, names));
  }
  return warnings;
}

}  // namespace thenar
