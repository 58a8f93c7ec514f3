#pragma once

/// Cross-validation of fits: predictions of postures, tendons and specimens that were left out.

#include <functional>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "kinematics_fit/prediction.h"
#include "solvers/least_squares.h"

namespace thenar {

/// Kind of trials that a fold leaves out.
enum class LeaveOut { kPosture, kTendon, kSpecimen };
inline constexpr std::array kLeaveOutNames{EnumName{LeaveOut::kPosture, "posture"},
                                           EnumName{LeaveOut::kTendon, "tendon"},
                                           EnumName{LeaveOut::kSpecimen, "specimen"}};

[[nodiscard]] std::string name_of(LeaveOut what);

/// Predictions of all left-out trials, and the folds that they belong to.
struct CrossValidation {
  LeaveOut what = LeaveOut::kPosture;
  std::vector<Prediction> experiments;  // trials of the folds done, predicted by fits without
                                        // them; error.trials is their number
  std::vector<std::string> folds;       // "HyperExt", "FDS", "H02"; the first folds_done are done
  int folds_done = 0;                   // folds fitted and predicted [1]
  Status status = Status::kSolved;      // kStopped: the unfinished fold is dropped
  int not_converged = 0;                // folds done whose fit did not converge [1]
};

/// Function that prepares the trials that a fold keeps before they are fitted, such as a choice of
/// settings.
using PrepareFold = std::function<FitProblem(const FitProblem& rest, const std::string& fold)>;

/// Refits once per fold and predicts the trials left out. A left-out specimen is predicted
/// from the population; a left-out posture or tendon from the specimen's own parameters, where
/// the errors of a left-out posture's own angles keep their prior variance.
/// @param prepare  nothing: folds are fitted as they are
/// @throws InputError if there are fewer than two folds.
[[nodiscard]] CrossValidation cross_validate(const FitProblem& problem, LeaveOut what,
                                             const SolveOptions& options = {},
                                             const PrepareFold& prepare = {});

}  // namespace thenar
