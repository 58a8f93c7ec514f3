#pragma once

/// Look-up of typed names in a list, with suggestions for misspelt ones.

#include <cstddef>
#include <string>
#include <vector>

namespace thenar {

/// Returns the smallest number of insertions, deletions and replacements of letters that turns `a`
/// into `b`.
[[nodiscard]] int edit_distance(const std::string& a, const std::string& b);

/// Returns the shortest name that begins with `wanted` (two letters or more), otherwise the most
/// similar one; empty if `names` is, or if more than half of the letters of every name differ.
[[nodiscard]] std::string nearest_name(const std::string& wanted,
                                       const std::vector<std::string>& names);

/// Returns ", did you mean 'x'?" with the nearest name, or "" if none is similar.
[[nodiscard]] std::string did_you_mean(const std::string& wanted,
                                       const std::vector<std::string>& names);

/// Returns the names joined as "a, b, c", or "none".
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

/// Returns the position of `name` in `names`, or of the only one that has it as a field_name().
/// @param kind   word for a name in messages: "muscle"
/// @param field  field of the request that has the name, for the error; empty: none
/// @throws InputError "no muscle 'FPD', did you mean 'FDP'? there are FDP, FDS" if it is not there.
[[nodiscard]] std::size_t index_of_name(const std::string& name,
                                        const std::vector<std::string>& names,
                                        const std::string& kind, const std::string& field = "");

}  // namespace thenar
