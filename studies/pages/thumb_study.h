#pragma once

#include <optional>

#include "report/blocks.h"
#include "studies/questions/study.h"

namespace thenar {

/// Returns the thumb study as one section: orthogonal and skewed axes at every noise, information
/// on the axes over noise and over postures, axes in space, modes, types, and calibration if it was
/// run. Fits whose chains do not agree are named in a banner and marked in the tables.
[[nodiscard]] Json thumb_study_section(const ThumbStudy& study,
                                       const std::optional<ThumbCalibration>& calibration = {});

/// Returns a table with a row for each fit and each thumb that was not fitted: errors of direction,
/// torque balance and coordination, and the gain in elpd over the orthogonal thumb on the same
/// data.
[[nodiscard]] Json thumb_comparison_table(const ThumbStudy& study);

/// Quantity on the horizontal axis of learnt_chart().
enum class Over { kNoise, kPostures };
/// Returns a chart of the ratio of posterior to prior sd, mean over the two tilts or shifts of each
/// axis, of fits without tasks of skewed thumbs with the published skewness. @param arms  selects
/// these fits
[[nodiscard]] Json learnt_chart(const ThumbStudy& study, Over over, Arms arms);

/// Returns a table of the modes of every fit: those that the search found, and the share of the
/// draws in each.
[[nodiscard]] Json thumb_mode_table(const ThumbStudy& study);

/// Returns a table of the probabilities of the four types of thumbs, by every fit of the skewed
/// model.
[[nodiscard]] Json thumb_type_table(const ThumbStudy& study);

/// Returns the page of the study.
[[nodiscard]] Json page_of(const ThumbStudyResult& result);

}  // namespace thenar
