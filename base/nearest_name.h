#pragma once

/// Suggestions for misspelt names.

#include <string>
#include <vector>

namespace thenar {

/// Least number of letters inserted, deleted or replaced that turns `a` into `b`.
[[nodiscard]] int edit_distance(const std::string& a, const std::string& b);

/// Returns the name most similar to `wanted`; empty if `names` is, or if more than half of the
/// letters of every name differ.
[[nodiscard]] std::string nearest_name(const std::string& wanted,
                                       const std::vector<std::string>& names);

/// ", did you mean 'x'?" with the nearest name, or "" if nothing is alike.
[[nodiscard]] std::string did_you_mean(const std::string& wanted,
                                       const std::vector<std::string>& names);

}  // namespace thenar
