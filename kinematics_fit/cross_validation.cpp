#include "kinematics_fit/cross_validation.h"

#include <algorithm>

#include "base/error.h"
#include "kinematics_fit/covariance.h"
#include "kinematics_fit/prior_scales.h"
#include "kinematics_fit/trivial_prediction.h"

namespace thenar {
namespace {

bool loads(const Trial& trial, const std::string& muscle) {
  const auto found = trial.tension.find(muscle);
  return found != trial.tension.end() && found->second > 0;
}

/// Returns whether the trial belongs to the fold.
bool in_fold(LeaveOut what, const std::string& fold, const Experiment& experiment,
             const Trial& trial) {
  if (what == LeaveOut::kPosture) return trial.posture == fold;
  if (what == LeaveOut::kTendon) return loads(trial, fold);
  return experiment.specimen == fold;
}

/// Returns the postures, tendons or specimens, in the order in which they first appear.
std::vector<std::string> list_folds(const FitProblem& problem, LeaveOut what) {
  std::vector<std::string> folds;
  const auto add = [&](const std::string& name) {
    if (std::find(folds.begin(), folds.end(), name) == folds.end()) folds.push_back(name);
  };
  for (const Experiment& experiment : problem.experiments()) {
    // Name folds by what they leave out.
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

/// Predicts the trials of one fold by a fit to all others.
void predict_fold(const FitProblem& rest, const Eigen::VectorXd& z, LeaveOut what,
                  const std::string& fold, const std::vector<Experiment>& experiments,
                  std::vector<Prediction>& out) {
  // Predict every experiment; a left-out specimen is unknown to the fit, and predicted from the
  // population.
  const ArrowMatrix C = laplace_blocks(rest, z);
  for (std::size_t e = 0; e < experiments.size(); ++e) {
    const Experiment& experiment = experiments[e];
    const int specimen = find_specimen(rest, experiment.specimen);
    const Prediction all = predict_experiment(rest, z, C, experiment, specimen);
    // Keep the predictions of the fold's trials.
    for (std::size_t i = 0; i < experiment.trials.size(); ++i) {
      if (!in_fold(what, fold, experiment, experiment.trials[i])) continue;
      out[e].trials.push_back(all.trials[i]);
      out[e].trials.back().trivial =
          trivial_force(experiment, experiment.trials[i], rest.experiments());
    }
  }
}

}  // namespace

std::string name_of(LeaveOut what) { return "leave one " + name_in(kLeaveOutNames, what) + " out"; }

CrossValidation cross_validate(const FitProblem& problem, LeaveOut what,
                               const SolveOptions& options, const PrepareFold& prepare) {
  // List the folds, and create a prediction for every experiment.
  CrossValidation out;
  out.what = what;
  out.folds = list_folds(problem, what);
  require(!out.folds.empty(), "to {}, wanted trials, got rows of activations alone", name_of(what));
  require(out.folds.size() >= 2, "to {}, there must be two or more; there is only '{}'",
          name_of(what), out.folds.front());
  for (const Experiment& experiment : problem.experiments())
    out.experiments.push_back(
        {experiment.name, {}, {}, calibrated_on_specimen(problem.digit(), experiment)});

  // Refit without each fold, then predict it.
  for (const std::string& fold : out.folds) {
    options.progress(static_cast<double>(out.folds_done) / static_cast<double>(out.folds.size()),
                     name_of(what));
    if (options.progress.stop()) out.status = Status::kStopped;
    if (out.status == Status::kStopped) break;
    FitProblem rest = subset(problem, [&](const Experiment& experiment, const Trial& trial) {
      return !in_fold(what, fold, experiment, trial);
    });
    if (prepare) rest = prepare(rest, fold);
    const ScaledFit scaled = fit_with_scales(rest, options);
    const Solution& fit = scaled.solution;
    // Discard a fit that was stopped: it has learnt less than its fold would suggest.
    if (fit.status == Status::kStopped) out.status = Status::kStopped;
    if (out.status == Status::kStopped) break;
    out.not_converged += fit.status == Status::kSolved ? 0 : 1;
    predict_fold(scaled.problem, fit.z, what, fold, problem.experiments(), out.experiments);
    ++out.folds_done;
  }

  // Compute errors over all trials, each of which was left out once.
  for (Prediction& prediction : out.experiments)
    if (!prediction.trials.empty()) prediction.error = force_error(prediction.trials);
  return out;
}

}  // namespace thenar
