#pragma once

/// Tables, charts and words of a comparison of hands.

#include "grasp/compare/comparison.h"
#include "report/blocks.h"

namespace thenar {

/// Returns a quantile by linear interpolation; NaN without values. @param p  probability, in [0, 1]
[[nodiscard]] double quantile_of(const Eigen::VectorXd& ascending, double p);

/// Returns a section with a line for every hand over all objects, and whether the comparison is
/// complete.
[[nodiscard]] Json glance_section(const Comparison& comparison);

/// Returns a section with success and best epsilon, hands by objects; every cell; reasons for zero
/// or unknown loads.
[[nodiscard]] Json cells_section(const Comparison& comparison);

/// Returns a section with quantiles of epsilon of every hand on every object, by geometry and with
/// the hand's own efforts.
[[nodiscard]] Json distribution_section(const Comparison& comparison);

/// Returns the section about the abilities of hands without an object.
[[nodiscard]] Json abilities_section(const Comparison& comparison);

/// Returns the section that explains the numbers and names the settings of the comparison.
[[nodiscard]] Json reading_section(const Comparison& comparison);

}  // namespace thenar
