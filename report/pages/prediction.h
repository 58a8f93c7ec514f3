#pragma once

/// Measured and predicted forces as arrows, and the page of a prediction.

#include <optional>
#include <string>

#include "api/predict.h"
#include "report/blocks.h"

namespace thenar {

/// Returns measured against predicted forces as arrows, one panel a posture, in the finger's
/// flexion plane and in the plane of its proximal and radial directions. Components must be
/// proximal, dorsal, radial. @param caption  says which predictions these are
[[nodiscard]] Json force_panels(const Prediction& prediction, const std::string& caption);

/// Returns the prediction with the components of its forces turned into proximal, dorsal and
/// radial.
[[nodiscard]] Prediction in_digit_axes(Prediction prediction, const Experiment& experiment);

/// Returns the root mean square errors by load and direction, beside those of the mean of others'
/// forces; nothing where nobody else measured these loads. Components must be proximal, dorsal,
/// radial.
[[nodiscard]] std::optional<Json> beside_trivial_table(const Prediction& prediction);

/// Returns warnings that predictions have.
[[nodiscard]] Json caution_banner(const std::vector<std::string>& warnings);

/// Returns the page of what a fit predicts.
[[nodiscard]] Json page_of(const PredictResult& result);

/// Returns the hashes of the inputs of a fit and of other sources, versions, fidelity, and the run
/// that fitted it, if that is known.
[[nodiscard]] Json fit_provenance(const FitInputs& inputs, const std::vector<SourceText>& more,
                                  const Fidelity& fidelity, const RunRecord& fitted_by);

}  // namespace thenar
