#pragma once

/// Hint for an unknown name, followed by the list of known names.

#include <string>
#include <vector>

namespace thenar {

/// Returns ", did you mean 'x'?" with the nearest name, or ";" if none is similar.
[[nodiscard]] std::string hint_before_list(const std::string& wanted,
                                           const std::vector<std::string>& names);

}  // namespace thenar
