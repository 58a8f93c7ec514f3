#pragma once

/// Guessing what a misspelt name was meant to be.

#include <string>
#include <vector>

namespace thenar {

/// Least number of letters inserted, deleted or replaced to turn `a` into `b`.
[[nodiscard]] int edit_distance(const std::string& a, const std::string& b);

/// The name most like `wanted`; empty if `names` is, or if none is at all alike
/// (more than half of the letters differ).
[[nodiscard]] std::string nearest_name(const std::string& wanted,
                                       const std::vector<std::string>& names);

/// ", did you mean 'x'?" with the nearest name, or "" if nothing is alike.
[[nodiscard]] std::string did_you_mean(const std::string& wanted,
                                       const std::vector<std::string>& names);

}  // namespace thenar
