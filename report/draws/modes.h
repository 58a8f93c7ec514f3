#pragma once

/// Modes of a posterior as a table.

#include <cstddef>
#include <vector>

#include "report/draws/draws.h"
#include "sampling/diagnostics/modes.h"

namespace thenar {

/// Returns a table with the share of the draws in each mode, the number of crossings of chains, and
/// the means of the quantities that best distinguish the modes, in their units.
/// @param quantities  of the same draws and chains as the table
/// @param most        largest number of quantities
/// @throws InputError if a quantity has other draws than the table.
[[nodiscard]] Json mode_table(const ModeTable& modes, const std::vector<Quantity>& quantities,
                              std::size_t most = 4);

}  // namespace thenar
