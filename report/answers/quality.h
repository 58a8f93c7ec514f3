#pragma once

/// Qualities of contacts as words, fields and a table.

#include <string>
#include <vector>

#include "api/quality.h"
#include "report/fields.h"

namespace thenar {

/// Returns a line for each quality, under the name of the file.
[[nodiscard]] std::string text_of(const ContactQualityResult& result);

/// Returns fields: members as docs/data_format.md has them; null: not known, or there is none.
[[nodiscard]] Fields fields_of(const ContactQualityResult& result);

/// Returns a table with a row for each contact set: bounds of epsilon, volume, rank, grasp matrix
/// and task.
[[nodiscard]] Table table_of(const std::vector<ContactQualityResult>& results);

/// Returns the only answer, or {"answers": [..]} of several.
[[nodiscard]] Fields fields_of(const std::vector<ContactQualityResult>& results);

}  // namespace thenar
