#pragma once

/// Words of messages: counts, and truncated lists.

#include <cstddef>
#include <string>
#include <vector>

namespace thenar {

/// Returns a count with its noun: "1 thing", "2 things".
[[nodiscard]] std::string counted(std::size_t count, const std::string& thing);

/// Returns at most `named` names and the number of the others: "a, b and 3 more".
[[nodiscard]] std::string some_of(const std::vector<std::string>& names, std::size_t named = 4);

/// Returns quoted names with their noun: "joint 'a'", "joints 'a', 'b' and 3 more".
[[nodiscard]] std::string quoted_list(const std::string& what,
                                      const std::vector<std::string>& names);

/// Returns a text with small letters instead of the capitals A to Z.
[[nodiscard]] std::string lower_case(std::string text);

/// Returns the first character behind a byte order mark and blanks; 0: there is none.
[[nodiscard]] char first_sign(const std::string& text);

}  // namespace thenar
