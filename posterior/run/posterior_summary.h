#pragma once

/// Summary of the draws of a run: the results shared by tables, pages and JSON.

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

/// Leave-one-out prediction of each observation from the others.
struct LeftOutObservations {
  LeaveOneOut result;
  std::vector<std::string>
      observations;  // names of the observations: "H01: Hook FDS" (observations)
};

/// Computes the leave-one-out prediction of a run; none with fewer than 4 draws per chain or if a
/// likelihood is not finite.
[[nodiscard]] std::optional<LeftOutObservations> leave_out_observations(const PosteriorRun& run);

/// Posterior predictive check of one fitted experiment.
struct ExperimentCheck {
  Prediction prediction;  // means of the draws with the measured forces
  PredictiveCheck check;
};

/// Summary of a run, in addition to its convergence, modes and swap rates.
struct PosteriorSummary {
  std::vector<PosteriorQuantity> quantities;
  std::vector<Estimate> estimates;           // estimates of the quantities, in their units
  std::vector<PosteriorAxes> axes;           // pairs of axes that the run moves
  LearntDirections directions;               // directions of the sampled coordinates, in prior sds
  std::vector<ExperimentCheck> experiments;  // experiments that have trials
  std::optional<LeftOutObservations> left_out;
};

/// Returns a warning for every experiment whose forces scatter beyond the stated noise: the 5 %
/// quantile of `noise/<experiment>`, the factor on the noise, is above 2.
/// @param estimates  estimates of the quantities, in the same order
[[nodiscard]] std::vector<std::string> noise_warnings(
    const std::vector<PosteriorQuantity>& quantities, const std::vector<Estimate>& estimates);

/// Summarises the draws of a run. @throws InputError if the run has fewer than 2 draws.
[[nodiscard]] PosteriorSummary summarise_posterior(const PosteriorRun& run);

}  // namespace thenar
