#pragma once

/// Verdicts on files, a line for each: their kind, or what is wrong with them.

#include "api/validate.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {

/// Returns a line for each file, "FILE: what it holds", or its error, which starts with the path;
/// doubts and misfits below.
[[nodiscard]] std::string text_of(const Validation& validation);
/// Returns a list of objects: [{"file", "valid", "holds" or "error", ..}].
[[nodiscard]] OrderedJson json_of(const Validation& validation);
/// Returns a table with a row for each file.
[[nodiscard]] Table table_of(const Validation& validation);

}  // namespace thenar
