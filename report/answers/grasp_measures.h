#pragma once

/// Measures of a grasp, and its robustness, as rows of text and as fields.

#include <string>
#include <vector>

#include "api/grasp.h"
#include "grasp/quality/grasp_matrix.h"
#include "report/fields.h"

namespace thenar {

/// A measure in words.
struct MeasureRow {
  std::string name, value;
  std::string note;  // why there is no value, or how it was computed; may be empty
};

/// Returns the measures; null where there is no value, with the message in `reasons`.
[[nodiscard]] Fields fields_of(const GraspMeasures& measures);
[[nodiscard]] Fields fields_of(const GraspMatrixMeasures& matrix);

/// Returns the measures in words. The first number of a load is supported by efforts and friction
/// alone.
[[nodiscard]] std::vector<MeasureRow> measure_rows(const GraspMeasures& measures);

/// Returns the shares of force closure with their intervals, and quantiles of epsilon.
/// @param result  grasp with GraspResult::robustness
[[nodiscard]] Fields robustness_fields(const GraspResult& result);
[[nodiscard]] std::vector<MeasureRow> robustness_rows(const GraspResult& result);

}  // namespace thenar
