#pragma once

#include <optional>

#include "report/blocks.h"
#include "studies/questions/study.h"

namespace thenar {

/// Returns the thumb study as one section: orthogonal beside skewed axes at every noise, what of
/// the axes was learnt over noise and over postures, axes in space, modes, types, and calibration
/// if it was run. Fits whose chains do not agree are named in a banner and marked in the tables.
[[nodiscard]] Json thumb_study_section(const ThumbStudy& study,
                                       const std::optional<ThumbCalibration>& calibration = {});

/// Returns one row a fit, and rows of the thumbs that were not fitted: errors of direction, torque
/// balance and coordination, and the gain in elpd over the orthogonal thumb on the same data.
[[nodiscard]] Json thumb_comparison_table(const ThumbStudy& study);

/// Share of the prior's sd that is left, mean over the two tilts or shifts of each axis.
enum class Over { kNoise, kPostures };
/// @param arms  fits with these, of skewed thumbs of the published skewness, without tasks
[[nodiscard]] Json learnt_chart(const ThumbStudy& study, Over over, Arms arms);

/// Returns modes of every fit: what the search found, and the share of the draws in each.
[[nodiscard]] Json thumb_mode_table(const ThumbStudy& study);

/// Returns probability of each of the four types of thumbs, by every fit of the skewed model.
[[nodiscard]] Json thumb_type_table(const ThumbStudy& study);

/// Returns the page of the study.
[[nodiscard]] Json page_of(const ThumbStudyResult& result);

}  // namespace thenar
