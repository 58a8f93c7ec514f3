#pragma once

/// Settings of a fit chosen by cross-validation: the variation between people, and the model error.
/// Never chosen by the data on which a fit is then evaluated.

#include <string>
#include <vector>

#include "kinematics_fit/cross_validation.h"
#include "solvers/least_squares.h"

namespace thenar {

/// Combination of choices that was tried.
struct TriedSettings {
  std::vector<std::size_t> chosen;  // index of the value of each choice
  double loss = 0;   // mean over experiments and kinds of folds of log loss + log relative error of
                     // held-out forces [nat]
  double error = 0;  // mean of the relative error alone [1]
};

/// Result of choose_settings(): the chosen settings, and the scores of all tried settings.
struct ChosenSettings {
  FitSettings settings;      // settings with the chosen values
  std::vector<LeaveOut> by;  // kinds of folds: postures; and specimens if there are several
  std::vector<TriedSettings>
      tried;         // combinations in the order in which they were tried; the first is the start
  double loss = 0;   // loss of the chosen settings, see TriedSettings; 0: none tried [nat]
  double error = 0;  // error of the chosen settings; 0: none tried [1]
  Status status = Status::kSolved;  // kStopped: the settings are the best of those tried
};

/// Chooses among settings.choices by coordinate descent until no single choice improves
///   loss = log loss + log(relative error)
/// averaged over held-out postures and, if there are several, held-out specimens. The two kinds of
/// folds test generalisation to new postures and to new people; the two terms test the interval and
/// the best guess. The log loss is a proper score, which is best on average if intervals are as
/// wide as the errors are. The logarithm of the relative error, i.e. the log loss of guesses with
/// one common sd, does not depend on the intervals.
/// @param also_free  see choose_parameters()
/// @throws InputError if there is nothing to choose, or there are fewer than two postures.
[[nodiscard]] ChosenSettings choose_settings(const FitProblem& problem, const FitSettings& settings,
                                             const std::vector<std::string>& also_free = {},
                                             const SolveOptions& options = {});

/// Returns the problem with the same trials under other settings.
[[nodiscard]] FitProblem with_settings(const FitProblem& problem, const FitSettings& settings,
                                       const std::vector<std::string>& also_free = {});

/// Settings chosen within one fold.
struct FoldChoice {
  std::string fold;
  ChosenSettings settings;
};

/// Predictions of fits whose settings were chosen without the predicted data.
struct NestedValidation {
  CrossValidation validation;
  std::vector<FoldChoice> folds;  // choices of the completed folds
};

/// Cross-validates choosing and fitting together: each fold chooses settings from its training
/// data, so that the error is that of the whole procedure.
/// @throws InputError as cross_validate() and choose_settings() do.
[[nodiscard]] NestedValidation validate_choice(const FitProblem& problem,
                                               const FitSettings& settings,
                                               const std::vector<std::string>& also_free,
                                               LeaveOut what, const SolveOptions& options = {});

}  // namespace thenar
