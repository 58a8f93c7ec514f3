#pragma once

/// Documentation of the table of methods, for docs/remote.md and `thenar serve --methods`.

#include <string>

#include "server/method.h"

namespace thenar {

/// Writes a section for each group of methods, in the order of the table: parameters (types, units,
/// ranges, default values), result and example of every method. Lines of prose have at most 118
/// columns.
[[nodiscard]] std::string methods_markdown(const MethodTable& table);

}  // namespace thenar
