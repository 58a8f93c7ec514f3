#include "kinematics_fit/cross_validation.h"

#include <algorithm>
#include <array>

#include "kinematics_fit/force_jacobian.h"

namespace thenar {
namespace {

bool loads(const Trial& trial, const std::string& muscle) {
  const auto found = trial.tension.find(muscle);
  return found != trial.tension.end() && found->second > 0;
}

/// Is the trial in the fold?
bool in_fold(LeaveOut what, const std::string& fold, const Experiment& experiment,
             const Trial& trial) {
  if (what == LeaveOut::kPosture) return trial.posture == fold;
  if (what == LeaveOut::kTendon) return loads(trial, fold);
  return experiment.specimen == fold;
}

/// Postures, tendons or specimens, in the order in which they first appear.
std::vector<std::string> list_folds(const FitProblem& problem, LeaveOut what) {
  std::vector<std::string> folds;
  const auto add = [&](const std::string& name) {
    if (std::find(folds.begin(), folds.end(), name) == folds.end()) folds.push_back(name);
  };
  for (const Experiment& experiment : problem.experiments()) {
    if (what == LeaveOut::kSpecimen) add(experiment.specimen);
    for (const Trial& trial : experiment.trials) {
      if (what == LeaveOut::kPosture) add(trial.posture);
      if (what == LeaveOut::kTendon)
        for (const auto& [muscle, tension] : trial.tension)
          if (tension > 0) add(muscle);
    }
  }
  return folds;
}

/// Forces of a whole experiment by a fit that need not contain it.
Eigen::Matrix3Xd forces_of(const FitProblem& fitted, const Eigen::VectorXd& z,
                           const Experiment& experiment) {
  return force_values(fitted.digit(), fitted.parameters(),
                      plan_experiment(fitted.digit(), fitted.parameters(), experiment),
                      fitted.displacements(z, find_specimen(fitted, experiment.specimen)));
}

}  // namespace

std::string name_of(LeaveOut what) {
  constexpr std::array kNames{"leave one posture out", "leave one tendon out",
                              "leave one specimen out"};
  return kNames[static_cast<std::size_t>(what)];
}

LeastSquares least_squares(const FitProblem& problem) {
  LeastSquares out;
  out.lower = problem.lower();
  out.upper = problem.upper();
  out.residuals = [&problem](const Eigen::VectorXd& z, WithJacobian want) {
    return problem.evaluate(z, want);
  };
  if (problem.axis_distances().empty()) return out;
  out.c_lower = problem.constraint_lower();
  out.c_upper = Eigen::VectorXd::Ones(out.c_lower.size());
  out.constraints = [&problem](const Eigen::VectorXd& z) { return problem.constraints(z); };
  return out;
}

FitProblem subset(const FitProblem& problem,
                  const std::function<bool(const Experiment&, const Trial&)>& keep) {
  std::vector<Experiment> kept;
  for (Experiment experiment : problem.experiments()) {
    std::vector<Trial>& trials = experiment.trials;
    trials.erase(std::remove_if(trials.begin(), trials.end(),
                                [&](const Trial& trial) { return !keep(experiment, trial); }),
                 trials.end());
    if (!trials.empty()) kept.push_back(std::move(experiment));
  }
  return {problem.digit(), problem.parameters(), std::move(kept), problem.robust_scale(),
          problem.axis_distances()};
}

CrossValidation cross_validate(const FitProblem& problem, LeaveOut what,
                               const SolveOptions& options) {
  CrossValidation out{what, {}, list_folds(problem, what), 0};
  require(out.folds.size() >= 2, "to {}, there must be two or more; there is only '{}'",
          name_of(what), out.folds.empty() ? "" : out.folds.front());
  for (const Experiment& experiment : problem.experiments())
    out.experiments.push_back({experiment.name, {}, {}});

  for (std::size_t k = 0; k < out.folds.size(); ++k) {
    options.progress(static_cast<double>(k) / static_cast<double>(out.folds.size()), name_of(what));
    if (options.progress.stop()) break;
    const std::string& fold = out.folds[k];
    const FitProblem rest = subset(problem, [&](const Experiment& experiment, const Trial& trial) {
      return !in_fold(what, fold, experiment, trial);
    });
    const Solution fit = solve(least_squares(rest), Eigen::VectorXd::Zero(rest.size()), options);
    out.not_converged += fit.status == SolveStatus::kConverged ? 0 : 1;

    for (std::size_t e = 0; e < problem.experiments().size(); ++e) {
      const Experiment& experiment = problem.experiments()[e];
      const Eigen::Matrix3Xd force = forces_of(rest, fit.z, experiment);
      for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
        const Trial& trial = experiment.trials[i];
        if (!in_fold(what, fold, experiment, trial)) continue;
        out.experiments[e].trials.push_back({trial.posture, describe_loads(trial), trial.force,
                                             force.col(static_cast<Eigen::Index>(i)),
                                             Eigen::Vector3d::Zero()});
      }
    }
  }
  for (Prediction& prediction : out.experiments) prediction.error = force_error(prediction.trials);
  return out;
}

}  // namespace thenar
