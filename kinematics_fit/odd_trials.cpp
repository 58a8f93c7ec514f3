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

constexpr double kOddProbability = 1e-3;  // largest tail probability of an outlier [1]
// Smallest distance of a trial that may be wrong instead, over that of the outlier [1]
constexpr double kRivalDistanceShare = 0.5;

/// Returns "FDS in posture 'Hook'", or "activation row 2 in posture 'Hook'".
std::string name_of(const Experiment& experiment, std::size_t row) {
  const std::size_t trials = experiment.trials.size();
  if (row >= trials)
    return fmt::format("activation row {} in posture '{}'", row - trials + 1,
                       experiment.activations[row - trials].posture);
  const Trial& trial = experiment.trials[row];
  return fmt::format("{} in posture '{}'", describe_loads(trial), trial.posture);
}

/// Residuals r of an experiment, and W with hat matrix H = W'W, three columns for each trial.
struct Leverage {
  Eigen::VectorXd r;
  const Eigen::MatrixXd& W;
};

/// Returns the squared distance of trial i from its prediction by the other trials, without the
/// trials S in `out`:
///   r -> r + H_iS (I - H_SS)^-1 r_S,   H_ii -> H_ii + H_iS (I - H_SS)^-1 H_Si.
double squared_distance(const Leverage& leverage, Eigen::Index i,
                        const std::vector<Eigen::Index>& out) {
  Eigen::Vector3d r = leverage.r.segment<3>(3 * i);
  const auto W = leverage.W.middleCols<3>(3 * i);
  Eigen::Matrix3d H = W.transpose() * W;
  // Remove the influence of the trials that are left out.
  if (!out.empty()) {
    const auto rows = 3 * static_cast<Eigen::Index>(out.size());
    Eigen::MatrixXd A(leverage.W.rows(), rows);
    Eigen::VectorXd r_out(rows);
    for (std::size_t k = 0; k < out.size(); ++k) {
      A.middleCols<3>(3 * static_cast<Eigen::Index>(k)) = leverage.W.middleCols<3>(3 * out[k]);
      r_out.segment<3>(3 * static_cast<Eigen::Index>(k)) = leverage.r.segment<3>(3 * out[k]);
    }
    const Eigen::MatrixXd cross = A.transpose() * W;
    const Eigen::LLT<Eigen::MatrixXd> rest(Eigen::MatrixXd::Identity(rows, rows) -
                                           A.transpose() * A);
    r += cross.transpose() * rest.solve(r_out);
    H += cross.transpose() * rest.solve(cross);
  }
  return r.dot((Eigen::Matrix3d::Identity() - H).llt().solve(r));
}

/// Returns the number of trials and activation rows of an experiment, as in data_residuals().
Eigen::Index rows_of(const FitProblem& problem, int e) { return force_rows(problem, e) / 3; }

/// Returns the outliers of an experiment, the furthest first, without those explained by the
/// removal of further ones.
std::vector<OddTrial> find_outliers(const FitProblem& problem, int e, const Leverage& leverage,
                                    double rows) {
  // Correct the tail probability for the number of rows.
  const ExperimentPlan& plan = problem.plans()[e];
  const auto tail_of = [&](Eigen::Index i, double squared) {
    const auto fitted = i < plan.sd.cols() ? (plan.sd.col(i).array() < HUGE_VAL).count()
                                           : Eigen::Index{plan.measured};
    return std::min(1.0, rows * chi_square_tail(squared, static_cast<double>(fitted)));
  };
  // Find trials that are far from the prediction by all others, and sort them by distance.
  std::vector<OddTrial> all;
  for (Eigen::Index i = 0; i < rows_of(problem, e); ++i) {
    const double squared = squared_distance(leverage, i, {}), tail = tail_of(i, squared);
    if (!(tail >= kOddProbability))
      all.push_back({e, static_cast<int>(i), std::sqrt(squared), tail, -1});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const OddTrial& a, const OddTrial& b) { return a.distance > b.distance; });
  // Keep those that are still far without the outliers before them; note the first rival.
  std::vector<OddTrial> odd;
  std::vector<Eigen::Index> out;
  for (const OddTrial& each : all) {
    if (!(tail_of(each.trial, squared_distance(leverage, each.trial, out)) >= kOddProbability)) {
      odd.push_back(each);
      out.push_back(each.trial);
    } else if (odd.front().instead < 0 &&
               each.distance > kRivalDistanceShare * odd.front().distance) {
      odd.front().instead = each.trial;
    }
  }
  return odd;
}

}  // namespace

std::vector<OddTrial> odd_trials(const FitProblem& problem, const Eigen::VectorXd& z,
                                 const Covariance& covariance) {
  std::vector<OddTrial> odd;
  const int experiments = static_cast<int>(problem.experiments().size());
  double rows = 0;
  for (int e = 0; e < experiments; ++e) rows += static_cast<double>(rows_of(problem, e));
  for (int e = 0; e < experiments; ++e) {
    // Remove the robust loss. Residuals that are not fitted are 0, and so are their slopes.
    Leverage leverage{data_residuals(problem, z, e, WithJacobian::kNo).r, covariance.leverage[e]};
    for (Eigen::Index i = 0; i < rows_of(problem, e); ++i)
      leverage.r.segment<3>(3 * i) =
          plain_residual(Eigen::Vector3d(leverage.r.segment<3>(3 * i)), problem.robust_scale());
    for (const OddTrial& each : find_outliers(problem, e, leverage, rows)) odd.push_back(each);
  }
  std::stable_sort(odd.begin(), odd.end(),
                   [](const OddTrial& a, const OddTrial& b) { return a.distance > b.distance; });
  return odd;
}

std::vector<std::string> describe(const FitProblem& problem, const std::vector<OddTrial>& odd) {
  // Largest number of outliers of an experiment that are named; the others are counted
  constexpr std::size_t kMaxNamedTrials = 3;
  std::vector<std::string> warnings;
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e) {
    const Experiment& experiment = problem.experiments()[e];
    // Name the furthest.
    std::vector<std::string> names;
    for (const OddTrial& each : odd)
      if (each.experiment == e)
        names.push_back(fmt::format(
            "{} ({:.1f} sds{})", name_of(experiment, static_cast<std::size_t>(each.trial)),
            each.distance,
            each.instead < 0 ? ""
                             : ", or in its stead " +
                                   name_of(experiment, static_cast<std::size_t>(each.instead))));
    if (names.empty()) continue;
    warnings.push_back(fmt::format(
        "experiment '{}': forces are far from what all other trials tell of them: {}. Is a row "
        "turned, of another load or posture, or in another unit? One such row can move all that is "
        "fitted",
        experiment.name, some_of(names, kMaxNamedTrials)));
  }
  return warnings;
}

}  // namespace thenar
