#pragma once

/// Summary of the draws of a run: the results that tables, pages and JSON share.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/prediction.h"
#include "posterior/run/posterior_axes.h"
#include "posterior/run/posterior_quantities.h"
#include "sampling/diagnostics/learnt_directions.h"
#include "sampling/diagnostics/leave_one_out.h"
#include "sampling/diagnostics/predictive.h"

namespace thenar {

/// Leave-one-out prediction of each observation by the others.
struct LeftOutObservations {
  LeaveOneOut result;
  std::vector<std::string> observations;  // "H01: Hook FDS" (observations)
};

/// Leave-one-out of a run; empty with fewer than 4 draws a chain or a likelihood that is not
/// finite.
[[nodiscard]] std::optional<LeftOutObservations> leave_out_observations(const PosteriorRun& run);

/// Posterior predictive check of one fitted experiment.
struct ExperimentCheck {
  Prediction prediction;  // means of the draws beside the measured forces
  PredictiveCheck check;
};

/// Summary of a run, in addition to its convergence, modes and swap rates.
struct PosteriorSummary {
  std::vector<PosteriorQuantity> quantities;
  std::vector<Estimate> estimates;           // of the quantities, in their units
  std::vector<PosteriorAxes> axes;           // that the run moves
  LearntDirections directions;               // of the sampled coordinates, in prior sds
  std::vector<ExperimentCheck> experiments;  // those with trials
  std::optional<LeftOutObservations> left_out;
};

/// A warning for every experiment whose forces scatter beyond the stated noise: the 5 % quantile of
/// `noise/<experiment>`, the factor on the noise, is above 2.
/// @param estimates  of the quantities, in the same order
[[nodiscard]] std::vector<std::string> noise_warnings(
    const std::vector<PosteriorQuantity>& quantities, const std::vector<Estimate>& estimates);

/// @throws InputError if the run has fewer than 2 draws.
[[nodiscard]] PosteriorSummary summarise_posterior(const PosteriorRun& run);

}  // namespace thenar
