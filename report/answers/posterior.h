#pragma once

/// Sampled posterior as text, fields and rows.

#include <string>

#include "api/posterior.h"
#include "report/fields.h"

namespace thenar {

/// Returns a posterior as text: convergence of the sampler, predicted beside measured forces,
/// leave-one-out, parameters, directions and modes.
[[nodiscard]] std::string text_of(const PosteriorResult& result);

/// Returns the complete posterior with unrounded numbers.
[[nodiscard]] Fields fields_of(const PosteriorResult& result);

/// Returns a table with a row for each parameter and factor, best known first.
[[nodiscard]] Table table_of(const PosteriorResult& result);

/// Return the predictions of the draws as text, fields and rows, like any prediction.
[[nodiscard]] std::string text_of(const PosteriorPrediction& result);
[[nodiscard]] std::vector<Fields> fields_of(const PosteriorPrediction& result);
[[nodiscard]] Table table_of(const PosteriorPrediction& result);

/// Returns the reasons why the draws must not be used; "" if they may be used, or sampling was
/// stopped.
[[nodiscard]] std::string refusal_of(const PosteriorResult& result);

/// Returns the reasons why draws must not be used, with remedies and commands; "" if they may be
/// used.
[[nodiscard]] std::string convergence_complaint(const PosteriorRun& run);

/// Returns cautions about converged draws, with remedies; often empty.
[[nodiscard]] std::vector<std::string> convergence_cautions(const PosteriorRun& run);

/// Returns cautions about experiments whose forces scatter far beyond the stated noise; see
/// noise_warnings(). Empty without a summary.
[[nodiscard]] std::vector<std::string> noise_cautions(const PosteriorResult& result);

}  // namespace thenar
