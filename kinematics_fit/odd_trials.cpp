#include "kinematics_fit/odd_trials.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "base/special_functions.h"
#include "base/words.h"
#include "kinematics_fit/fit_residuals.h"
#include "kinematics_fit/prediction.h"

namespace thenar {
namespace {

constexpr double kOdd = 1e-3;  // tail probability of an odd trial [1]

/// "FDS in posture 'Hook'", or "activation row 2 in posture 'Hook'".
std::string name_of(const Experiment& experiment, std::size_t row) {
  const std::size_t trials = experiment.trials.size();
  if (row >= trials)
    return fmt::format("activation row {} in posture '{}'", row - trials + 1,
                       experiment.activations[row - trials].posture);
  const Trial& trial = experiment.trials[row];
  return fmt::format("{} in posture '{}'", describe_loads(trial), trial.posture);
}

/// Squared distance of a trial from what all others tell of it, see odd_trials() [1].
/// @param W  with H = W'W (., 3)
double squared_distance(const Eigen::Vector3d& r, const Eigen::MatrixXd& W) {
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - W.transpose() * W;
  return r.dot(rest.llt().solve(r));
}

/// Trials and rows of activations of an experiment, as data_residuals() has them.
Eigen::Index rows_of(const FitProblem& problem, int e) { return force_rows(problem, e) / 3; }

}  // namespace

std::vector<OddTrial> odd_trials(const FitProblem& problem, const Eigen::VectorXd& z,
                                 const Covariance& covariance) {
  std::vector<OddTrial> odd;
  const int experiments = static_cast<int>(problem.experiments().size());
  double rows = 0;
  for (int e = 0; e < experiments; ++e) rows += static_cast<double>(rows_of(problem, e));
  for (int e = 0; e < experiments; ++e) {
    const ExperimentPlan& plan = problem.plans()[static_cast<std::size_t>(e)];
    const Eigen::VectorXd all = data_residuals(problem, z, e, WithJacobian::kNo).r;
    const Eigen::MatrixXd& W = covariance.leverage[static_cast<std::size_t>(e)];
    for (Eigen::Index i = 0; i < rows_of(problem, e); ++i) {
      // Residuals that are not fitted are 0, and so are their slopes.
      const Eigen::Vector3d r = plain_residual(all.segment<3>(3 * i), problem.robust_scale());
      const double squared = squared_distance(r, W.middleCols<3>(3 * i));
      const auto fitted = i < plan.sd.cols() ? (plan.sd.col(i).array() < HUGE_VAL).count()
                                             : Eigen::Index{plan.measured};
      const double tail =
          std::min(1.0, rows * chi_square_tail(squared, static_cast<double>(fitted)));
      if (!(tail >= kOdd)) odd.push_back({e, static_cast<int>(i), std::sqrt(squared), tail});
    }
  }
  std::sort(odd.begin(), odd.end(),
            [](const OddTrial& a, const OddTrial& b) { return a.distance > b.distance; });
  return odd;
}

std::vector<std::string> describe(const FitProblem& problem, const std::vector<OddTrial>& odd) {
  constexpr std::size_t kNamed = 3;  // of an experiment; the others are counted
  std::vector<std::string> warnings;
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e) {
    const Experiment& experiment = problem.experiments()[static_cast<std::size_t>(e)];
    // The oddest by name.
    std::vector<std::string> names;
    for (const OddTrial& each : odd)
      if (each.experiment == e)
        names.push_back(fmt::format("{} ({:.1f} sds)",
                                    name_of(experiment, static_cast<std::size_t>(each.trial)),
                                    each.distance));
    if (names.empty()) continue;
    warnings.push_back(fmt::format(
        "experiment '{}': forces are far from what all other trials tell of them: {}. Is a row "
        "turned, of another load or posture, or in another unit? One such row can move all that is "
        "fitted",
        experiment.name, some_of(names, kNamed)));
  }
  return warnings;
}

}  // namespace thenar
