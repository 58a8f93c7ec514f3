#pragma once

/// The table of methods as a document, for docs/remote.md and `thenar serve --methods`.

#include <string>

#include "server/method.h"

namespace thenar {

/// A section for each group of methods, in the order of the table, with what every method takes
/// (types, units, ranges, usual values) and gives, and an example. Lines end at column 140, but for
/// rows of tables.
[[nodiscard]] std::string methods_markdown(const MethodTable& table);

}  // namespace thenar
