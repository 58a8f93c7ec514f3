#pragma once

/// Warnings of imports, put in order.

#include <string>
#include <vector>

namespace thenar::internal {

/// The same one once, with " (N times)"; first what is missing or unreadable (in capitals: MISSING,
/// UNREADABLE, INCOMPLETE, LEFT OUT), then what was changed, last elements that are not read, as
/// gains and colours.
[[nodiscard]] std::vector<std::string> by_weight(const std::vector<std::string>& warnings);

}  // namespace thenar::internal
