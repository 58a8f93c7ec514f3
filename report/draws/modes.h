#pragma once

/// Modes of a posterior as a table.

#include <cstddef>
#include <vector>

#include "report/draws/draws.h"
#include "sampling/diagnostics/modes.h"

namespace thenar {

/// Returns the share of the draws in each mode, how often chains cross, and means of the quantities
/// that tell the modes apart best, in their units.
/// @param quantities  of the same draws and chains as the table
/// @param most        quantities shown
/// @throws InputError if a quantity has other draws than the table.
[[nodiscard]] Json mode_table(const ModeTable& modes, const std::vector<Quantity>& quantities,
                              std::size_t most = 4);

}  // namespace thenar
