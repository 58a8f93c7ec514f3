#pragma once

/// Measures of a grasp, and its robustness, as rows of words and as fields.

#include <string>
#include <vector>

#include "api/grasp.h"
#include "grasp/quality/grasp_matrix.h"
#include "report/fields.h"

namespace thenar {

/// A measure in words.
struct MeasureRow {
  std::string name, value;
  std::string note;  // why there is none, or how it was found; may be empty
};

/// Returns the measures; null where there is no value, `reasons` says why.
[[nodiscard]] Fields fields_of(const GraspMeasures& measures);
[[nodiscard]] Fields fields_of(const GraspMatrixMeasures& matrix);

/// Returns the measures in words. The first number of a load is the load that efforts and friction
/// support.
[[nodiscard]] std::vector<MeasureRow> measure_rows(const GraspMeasures& measures);

/// Returns shares of force closure with their intervals, and quantiles of epsilon.
/// @param result  that has GraspResult::robustness
[[nodiscard]] Fields robustness_fields(const GraspResult& result);
[[nodiscard]] std::vector<MeasureRow> robustness_rows(const GraspResult& result);

}  // namespace thenar
