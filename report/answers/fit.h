#pragma once

/// A fit as words, fields and rows.

#include <string>

#include "api/fit.h"
#include "report/fields.h"

namespace thenar {

/// Returns a fit as text: its ending, errors in sample and left out, what the data determine best,
/// and what the prior alone determines.
[[nodiscard]] std::string text_of(const FitResult& result);

/// Returns a fit complete and with unrounded numbers.
[[nodiscard]] Fields fields_of(const FitResult& result);

/// Returns a table with a row for each coordinate of the fit, best known first: its meaning, and
/// estimate and sd in prior sds.
[[nodiscard]] Table table_of(const FitResult& result);

/// Returns the reason why the best point is not to be used; "" if it has converged.
/// @param allowed  the person asked for it all the same
[[nodiscard]] std::string fit_complaint(const FitResult& result, bool allowed);

/// Returns "postures and specimens left out": what settings were chosen by.
[[nodiscard]] std::string judged_words(const ChosenSettings& chosen);
/// Returns a table with a row for each choice of settings: its value at first and chosen, and those
/// of the folds of every cross-validation. No rows where nothing was tried.
[[nodiscard]] Table choice_table(const FitResult& result);

/// Returns "; the subject has seen this specimen" behind an error that is not of a stranger, else
/// "".
[[nodiscard]] std::string seen_words(const Prediction& prediction);

/// Returns "; the mean of others' forces 0.598", the error of trivial_force() on the same trials;
/// "" where nobody else measured them.
[[nodiscard]] std::string trivial_words(const Prediction& prediction,
                                        const std::string& who = "the mean of others' forces");
/// Returns the error of trivial_words() as numbers, or null.
[[nodiscard]] Field trivial_field(std::string key, const Prediction& prediction);

}  // namespace thenar
