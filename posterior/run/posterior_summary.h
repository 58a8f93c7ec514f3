#pragma once

/// What the draws of a run say, in numbers that a table, a page and JSON share.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/prediction.h"
#include "posterior/run/posterior_quantities.h"
#include "sampling/diagnostics/learnt_directions.h"
#include "sampling/diagnostics/leave_one_out.h"
#include "sampling/diagnostics/predictive.h"

namespace thenar {

/// How well each observation would have been predicted by the others.
struct LeftOutObservations {
  LeaveOneOut result;
  std::vector<std::string> observations;  // "H01: Hook FDS" (observations)
};

/// Nothing if there are fewer than 4 draws a chain, or a likelihood is not finite.
[[nodiscard]] std::optional<LeftOutObservations> leave_out_observations(const PosteriorRun& run);

/// One fitted experiment beside its replicates.
struct ExperimentCheck {
  Prediction prediction;  // means of the draws beside the measured forces
  PredictiveCheck check;
};

/// Everything that a summary tells beside the run's own convergence, modes and swap rates.
struct PosteriorSummary {
  std::vector<PosteriorQuantity> quantities;
  std::vector<Estimate> estimates;           // of the quantities, in their units
  LearntDirections directions;               // of the sampled coordinates, in prior sds
  std::vector<ExperimentCheck> experiments;  // those with trials
  std::optional<LeftOutObservations> left_out;
};

/// @throws InputError if the run has fewer than 2 draws.
[[nodiscard]] PosteriorSummary summarise_posterior(const PosteriorRun& run);

}  // namespace thenar
