#pragma once

/// Qualities of contacts as text, fields and a table.

#include <string>
#include <vector>

#include "api/quality.h"
#include "report/fields.h"

namespace thenar {

/// Returns a line for each quality, under the name of the file.
[[nodiscard]] std::string text_of(const ContactQualityResult& result);

/// Returns the fields described in docs/data_format.md; null: not known, or undefined.
[[nodiscard]] Fields fields_of(const ContactQualityResult& result);

/// Returns a table with a row for each contact set: bounds of epsilon, volume, rank, grasp matrix
/// and task.
[[nodiscard]] Table table_of(const std::vector<ContactQualityResult>& results);

/// Returns the fields of a single result, or {"answers": [..]} for several.
[[nodiscard]] Fields fields_of(const std::vector<ContactQualityResult>& results);

}  // namespace thenar
