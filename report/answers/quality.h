#pragma once

/// Qualities of contacts as words, JSON and a table.

#include <string>
#include <vector>

#include "api/quality.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {

/// A line for each quality, under the name of the file.
[[nodiscard]] std::string text_of(const ContactQuality& result);

/// Members as docs/data_format.md has them; null: not known, or there is none.
[[nodiscard]] OrderedJson json_of(const ContactQuality& result);

/// A row for each contact set: bounds of epsilon, volume, rank, grasp matrix and task.
[[nodiscard]] Table table_of(const std::vector<ContactQuality>& results);

/// The only answer, or {"answers": [..]} of several.
[[nodiscard]] OrderedJson json_of(const std::vector<ContactQuality>& results);

}  // namespace thenar
