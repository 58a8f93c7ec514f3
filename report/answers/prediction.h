#pragma once

/// Predicted and measured forces as text, fields and rows.

#include <string>
#include <vector>

#include "api/predict.h"
#include "report/fields.h"

namespace thenar {

/// Returns predictions as text: for each experiment the predicting parameters, every trial, and the
/// errors.
[[nodiscard]] std::string text_of(const PredictResult& result);

/// Returns the fields of each experiment.
[[nodiscard]] std::vector<Fields> fields_of(const PredictResult& result);

/// Returns a table with a row for each trial of each experiment. Columns 1, 2 and 3 are the
/// components in the order of the column "components".
[[nodiscard]] Table table_of(const PredictResult& result);

/// Returns the reason why the forces must not be used: the fit has not converged; else "".
[[nodiscard]] std::string refusal_of(const PredictResult& result);

/// Returns the directions of the three components of a force: "proximal dorsal -radial".
[[nodiscard]] std::string component_names(const Experiment& experiment);

/// Returns the meaning in words: "was never fitted; the population predicts".
[[nodiscard]] std::string in_words(PredictedBy by);

}  // namespace thenar
