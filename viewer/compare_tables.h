#pragma once

/// Tables, charts and words of a comparison of hands.

#include "grasp/compare/comparison.h"
#include "viewer/blocks.h"

namespace thenar {

/// A line for every hand over all objects, and whether the comparison is whole.
[[nodiscard]] Json glance_section(const Comparison& comparison);

/// Success and best epsilon, hands by objects; then every cell.
[[nodiscard]] Json cells_section(const Comparison& comparison);

/// Quantiles of epsilon of every hand on every object.
[[nodiscard]] Json distribution_section(const Comparison& comparison);

/// What hands can do without an object.
[[nodiscard]] Json abilities_section(const Comparison& comparison);

/// What the numbers mean, and with which settings they came about.
[[nodiscard]] Json reading_section(const Comparison& comparison);

}  // namespace thenar
