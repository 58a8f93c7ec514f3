#pragma once

/// Study of simulated thumbs as text, fields and rows.

#include <string>

#include "base/provenance.h"
#include "report/fields.h"
#include "studies/questions/study.h"

namespace thenar {

/// Returns the errors of each fit in explaining forces of the true thumb.
[[nodiscard]] std::string text_of(const ThumbStudyResult& result);

/// Returns the fits with their learnt numbers, thumbs that were not fitted, and the calibration if
/// there is one.
[[nodiscard]] Fields fields_of(const ThumbStudyResult& result);

/// Returns a table with a row for each fit: errors of directions and forces, of tasks, elpd, modes,
/// R-hat.
[[nodiscard]] Table table_of(const ThumbStudyResult& result);

/// Returns the digests of the files of the true thumb and of those that were fitted.
[[nodiscard]] FileDigests files_of(const ThumbStudyResult& result);

/// Returns why the study is not reliable: "3 of 12 fits have NOT converged; they are marked .."; ""
/// if it is.
[[nodiscard]] std::string study_complaint(const ThumbStudyResult& result);

}  // namespace thenar
