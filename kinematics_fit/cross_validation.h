#pragma once

/// Cross-validation of fits: predictions of held-out postures, tendons and specimens.

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

/// Returns "leave one posture out", or the like for tendons and specimens.
[[nodiscard]] std::string name_of(LeaveOut what);

/// Predictions of all held-out trials, and their folds.
struct CrossValidation {
  LeaveOut what = LeaveOut::kPosture;
  std::vector<Prediction> experiments;  // trials of the completed folds, predicted by fits without
                                        // them; error.trials is their number
  std::vector<std::string>
      folds;  // names of all folds: "HyperExt", "FDS", "H02"; the first folds_done are completed
  int folds_done = 0;               // number of folds fitted and predicted [1]
  Status status = Status::kSolved;  // kStopped: the unfinished fold is dropped
  int not_converged = 0;            // number of completed folds whose fit did not converge [1]
};

/// Function that prepares the training trials of a fold before they are fitted, e.g. by choosing
/// settings.
using PrepareFold = std::function<FitProblem(const FitProblem& rest, const std::string& fold)>;

/// Refits once per fold and predicts the held-out trials: a specimen from the population; a posture
/// or tendon from the specimen's own parameters, where the angle errors of a held-out posture keep
/// their prior variance.
/// @param prepare  preparation of each fold; empty: none
/// @throws InputError if there are fewer than two folds.
[[nodiscard]] CrossValidation cross_validate(const FitProblem& problem, LeaveOut what,
                                             const SolveOptions& options = {},
                                             const PrepareFold& prepare = {});

}  // namespace thenar
