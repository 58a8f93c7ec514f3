#pragma once

/// Measured and predicted forces as arrows, and the page of a prediction.

#include <optional>
#include <string>

#include "api/predict.h"
#include "report/blocks.h"

namespace thenar {

/// Returns panels of measured and predicted forces as arrows, one for each posture, in the finger's
/// flexion plane and in the plane of its proximal and radial directions. Components must be
/// proximal, dorsal, radial. @param caption  describes the predictions
[[nodiscard]] Json force_panels(const Prediction& prediction, const std::string& caption);

/// Returns the prediction with the components of its forces turned into proximal, dorsal and
/// radial.
[[nodiscard]] Prediction in_digit_axes(Prediction prediction, const Experiment& experiment);

/// Returns the root mean square errors by load and direction, beside those of the mean of others'
/// forces; absent if no other specimen has these loads. Components must be proximal, dorsal,
/// radial.
[[nodiscard]] std::optional<Json> beside_trivial_table(const Prediction& prediction);

/// Returns a banner with the warnings of predictions.
[[nodiscard]] Json caution_banner(const std::vector<std::string>& warnings);

/// Returns the page of a fit's predictions.
[[nodiscard]] Json page_of(const PredictResult& result);

/// Returns the hashes of the inputs of a fit and of other sources, versions, fidelity, and the run
/// that fitted it, if that is known.
[[nodiscard]] Json fit_provenance(const FitInputs& inputs, const std::vector<SourceText>& more,
                                  const Fidelity& fidelity, const RunRecord& fitted_by);

}  // namespace thenar
