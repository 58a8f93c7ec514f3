#pragma once

/// Settings of a fit chosen by data that were left out: how far people differ, how much the model
/// misses. Never by the data that a fit is then judged by.

#include <string>
#include <vector>

#include "kinematics_fit/cross_validation.h"
#include "solvers/least_squares.h"

namespace thenar {

/// One set of choices that was tried.
struct TriedSettings {
  std::vector<std::size_t> chosen;  // of each choice, in its values
  double loss;                      // mean over experiments, and over what is left out, of log loss
                                    // + log relative error of forces that a fit has not seen [nat]
  double error;                     // the same of the relative error alone [1]
};

/// Result of choose_settings(): the chosen settings, and the scores of all tried settings.
struct ChosenSettings {
  FitSettings settings;              // with the choices in force
  std::vector<LeaveOut> by;          // postures; and specimens, where there are several
  std::vector<TriedSettings> tried;  // each once, in their order; the first is the start
  double loss = 0;                   // of the settings chosen, see TriedSettings; 0 where none were
  double error = 0;                  // tried [nat], [1]
  Status status = Status::kSolved;   // kStopped: the settings are the best of those tried
};

/// Chooses among settings.choices, one choice at a time, over and over until none is bettered: by
///   loss = log loss + log(relative error)
/// of left-out postures, and as much of left-out specimens, where there are several. A fit is asked
/// about both: the same hand in another posture, and strangers; and for both: its best guess, and
/// how far off that may be. The log loss is a proper score, least on average where intervals are as
/// wide as errors are; of the logarithm of the relative error, the log loss of guesses of one
/// common sd, intervals are no part.
/// @param also_free  as in choose_parameters()
/// @throws InputError if there is nothing to choose, or fewer than two postures.
[[nodiscard]] ChosenSettings choose_settings(const FitProblem& problem, const FitSettings& settings,
                                             const std::vector<std::string>& also_free = {},
                                             const SolveOptions& options = {});

/// Returns the problem with the same trials under other settings.
[[nodiscard]] FitProblem with_settings(const FitProblem& problem, const FitSettings& settings,
                                       const std::vector<std::string>& also_free = {});

/// Settings that one fold chose.
struct FoldChoice {
  std::string fold;
  ChosenSettings settings;
};

/// Predictions of fits whose settings were chosen without what they predict.
struct NestedValidation {
  CrossValidation validation;
  std::vector<FoldChoice> folds;  // of the folds done
};

/// Cross-validation of choosing and fitting together: each fold chooses anew by what it keeps, so
/// that the error is that of the whole procedure.
/// @throws InputError as cross_validate() and choose_settings() do.
[[nodiscard]] NestedValidation validate_choice(const FitProblem& problem,
                                               const FitSettings& settings,
                                               const std::vector<std::string>& also_free,
                                               LeaveOut what, const SolveOptions& options = {});

}  // namespace thenar
