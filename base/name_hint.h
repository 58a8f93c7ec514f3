#pragma once

/// Hint for a name that is not known, before the list of the names that there are.

#include <string>
#include <vector>

namespace thenar {

/// Returns ", did you mean 'x'?" with the nearest name, or ";" if nothing is alike.
[[nodiscard]] std::string hint_before_list(const std::string& wanted,
                                           const std::vector<std::string>& names);

}  // namespace thenar
