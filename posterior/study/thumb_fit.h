#pragma once

#include "kinematics_fit/prediction.h"
#include "posterior/study/thumb_study.h"

namespace thenar::internal {

/// Data of a noise and a number of postures, and the digits that they are between.
struct ThumbData {
  const TendonDigit& truth;  // in the frame of `start`
  const TendonDigit& start;
  Experiment pulls;
  Experiment tasks;
};

/// Mean and sd over trials of the angle between predicted and measured force [rad].
struct DirectionErrors {
  double mean, sd;
};
[[nodiscard]] DirectionErrors direction_errors(const Prediction& prediction);

/// What a fit is given: files, and globs of the arms that it may move.
[[nodiscard]] FitInputs thumb_fit_inputs(const ThumbStudyInputs& inputs,
                                         const ThumbFitSettings& settings, const ThumbData& data);

/// Samples; where chains do not agree again, each time twice as long and with shorter steps.
[[nodiscard]] PosteriorRun sample_with_retries(const FitInputs& inputs, PosteriorSettings settings,
                                               int retries);

/// Samples, again and longer where chains do not agree, and scores. `run` has no draws if stopped.
[[nodiscard]] ThumbFit run_thumb_fit(const ThumbStudyInputs& inputs,
                                     const ThumbFitSettings& settings, const ThumbData& data,
                                     const ThumbStudySettings& study);

}  // namespace thenar::internal
