#pragma once

/// Text, JSON, tables and the page of a scene on several rungs of its finger pads.

#include <string>

#include "api/scenes/compare_rungs.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {

/// Returns the comparison as text: the cost of each rung, its error against the finest, and its
/// pads at the end.
[[nodiscard]] std::string text_of(const RungComparison& comparison);
[[nodiscard]] OrderedJson json_of(const RungComparison& comparison);
/// Returns a table with a row for each rung.
[[nodiscard]] Table table_of(const RungComparison& comparison);
/// Returns a table with a row for each rung and pad: its load at the end.
[[nodiscard]] Table pad_table_of(const RungComparison& comparison);

/// Returns the reference of the errors: "against elements", and whether that rung was solved.
[[nodiscard]] std::string finest_words(const RungComparison& comparison);
/// Returns the CPU time per simulated second [s]; not a number where nothing was simulated.
[[nodiscard]] double cpu_per_second(const RungRun& run);

/// Returns a page with error over cost of the rungs, forces over time, and a film of each rung.
[[nodiscard]] Json page_of(const RungComparison& comparison);

/// Returns the reason why the comparison must not be used: the finest run was not solved; empty if
/// it may.
[[nodiscard]] std::string refusal_of(const RungComparison& comparison);

}  // namespace thenar
