#pragma once

/// Fit as text, fields and rows.

#include <string>

#include "api/fit.h"
#include "report/fields.h"

namespace thenar {

/// Returns a fit as text: its status, errors in sample and left out, the coordinates that the data
/// determine best, and those that the prior alone determines.
[[nodiscard]] std::string text_of(const FitResult& result);

/// Returns the complete fit with unrounded numbers.
[[nodiscard]] Fields fields_of(const FitResult& result);

/// Returns a table with a row for each coordinate of the fit, best known first: its meaning, and
/// estimate and sd in prior sds.
[[nodiscard]] Table table_of(const FitResult& result);

/// Returns the reason why the best point must not be used; "" if the fit has converged, or was
/// stopped.
[[nodiscard]] std::string refusal_of(const FitResult& result);

/// Returns the data by which settings were chosen: "postures and specimens left out".
[[nodiscard]] std::string judged_words(const ChosenSettings& chosen);
/// Returns a table with a row for each choice of settings: initial and chosen value, and those of
/// the folds of every cross-validation; without rows if nothing was tried.
[[nodiscard]] Table choice_table(const FitResult& result);

/// Returns "; the subject has seen this specimen" if the specimen is not new to the subject, else
/// "".
[[nodiscard]] std::string seen_words(const Prediction& prediction);

/// Returns the error of trivial_force() on the same trials: "; the mean of others' forces 0.598";
/// "" where no other specimen has them.
[[nodiscard]] std::string trivial_words(const Prediction& prediction,
                                        const std::string& who = "the mean of others' forces");
/// Returns the error of trivial_words() as numbers, or null.
[[nodiscard]] Field trivial_field(std::string key, const Prediction& prediction);

}  // namespace thenar
