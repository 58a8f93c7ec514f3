#pragma once

/// How well a fit predicts what it has not seen.

#include <string>
#include <vector>

#include "kinematics_fit/prediction.h"

namespace thenar {

/// What is left out of a fold.
enum class LeaveOut { kPosture, kTendon, kSpecimen };

[[nodiscard]] std::string name_of(LeaveOut what);

/// Trials of one experiment predicted while left out, and what was left out when.
struct CrossValidation {
  LeaveOut what;
  std::vector<Prediction> experiments;  // every trial predicted by a fit that never saw it
  std::vector<std::string> folds;       // "HyperExt", "FDS", "H02"
  int not_converged = 0;                // folds whose fit did not converge [1]
};

/// Refits once per fold and predicts the trials left out. A left-out specimen is predicted
/// from the population; a left-out posture or tendon from the specimen's own parameters.
/// @throws InputError if there are fewer than two folds.
[[nodiscard]] CrossValidation cross_validate(const FitProblem& problem, LeaveOut what,
                                             const SolveOptions& options = {});

/// The problem without the trials of one fold; empty experiments are dropped.
/// @param keep  keep(experiment, trial)
[[nodiscard]] FitProblem subset(const FitProblem& problem,
                                const std::function<bool(const Experiment&, const Trial&)>& keep);

/// The least-squares problem of a fit, for solve(); refers to `problem`.
[[nodiscard]] LeastSquares least_squares(const FitProblem& problem);

}  // namespace thenar
