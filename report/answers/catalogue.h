#pragma once

/// Names that commands accept, as lines, a table and JSON.

#include <string>

#include "api/named/catalogue.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {

/// Returns a table of names and titles under each kind.
[[nodiscard]] std::string text_of(const Catalogue& catalogue);
/// Returns a list of objects: [{"kind", "name", "about", "source", "file"}].
[[nodiscard]] OrderedJson json_of(const Catalogue& catalogue);
[[nodiscard]] Table table_of(const Catalogue& catalogue);

}  // namespace thenar
