#pragma once

/// One fit of the thumb study: its inputs, its posterior and its scores.

#include "kinematics_fit/prediction.h"
#include "studies/thumb/thumb_study.h"

namespace thenar::internal {

/// Simulated data of one noise level and number of postures, with their true digit and the digit at
/// which fits start.
struct ThumbData {
  TendonDigit truth;  // true thumb in the frame of `start`
  TendonDigit start;
  Experiment pulls;
  Experiment tasks;
  MeanThumb criteria{};  // criteria of thumb types
};

/// Returns the thumb of a subject without passive moments: load cells are zeroed under the thumb at
/// rest, so that forces are those of tendons alone.
[[nodiscard]] TendonDigit thumb_of(const SourceText& source);

/// Mean and sd over trials of the angle between predicted and measured force [rad].
struct DirectionErrors {
  double mean, sd;
};
[[nodiscard]] DirectionErrors direction_errors(const Prediction& prediction);

/// Returns the inputs of a fit: files, and globs of the free arms.
[[nodiscard]] FitInputs thumb_fit_inputs(const ThumbStudyInputs& inputs,
                                         const ThumbFitSettings& settings, const ThumbData& data);

/// Returns the settings of the chains of a study or a recovery. @param file  settings with priors
template <typename Study>
[[nodiscard]] PosteriorSettings chain_settings(const SourceText& file, const Study& study) {
  PosteriorSettings out;
  out.posterior = posterior_options(file);
  out.run.draws = study.draws;
  out.run.sampler.warm_up = study.warm_up;
  out.run.sampler.seed = study.seed;
  out.run.progress.stop_requested = study.progress.stop_requested;
  out.mode_starts = study.mode_starts;
  return out;
}

/// Samples a posterior; while chains disagree, samples again with twice as many draws and shorter
/// steps.
/// @param retries  largest number of repetitions [1]
[[nodiscard]] PosteriorRun sample_with_retries(const FitInputs& inputs, PosteriorSettings settings,
                                               int retries);

/// Samples with retries and scores the result. `run` has no complete draws if it was stopped.
[[nodiscard]] ThumbFit run_thumb_fit(const ThumbStudyInputs& inputs,
                                     const ThumbFitSettings& settings, const ThumbData& data,
                                     const ThumbStudySettings& study);

}  // namespace thenar::internal
