#pragma once

#include "posterior/study/thumb_study.h"

namespace thenar::internal {

/// Data of a noise and a number of postures, and the digits that they are between.
struct ThumbData {
  const TendonDigit& truth;  // in the frame of `start`
  const TendonDigit& start;
  Experiment pulls;
  Experiment tasks;
};

/// What a fit is given: files, and globs of the arms that it may move.
[[nodiscard]] FitInputs case_inputs(const ThumbStudyInputs& inputs,
                                    const ThumbCaseSettings& settings, const ThumbData& data);

/// Samples, again and longer where chains do not agree, and scores. `run` has no draws if stopped.
[[nodiscard]] ThumbCase run_thumb_case(const ThumbStudyInputs& inputs,
                                       const ThumbCaseSettings& settings, const ThumbData& data,
                                       const ThumbStudySettings& study);

}  // namespace thenar::internal
