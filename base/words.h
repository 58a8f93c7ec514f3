#pragma once

/// Words of messages: numbers of things, and lists that are cut short.

#include <cstddef>
#include <string>
#include <vector>

namespace thenar {

/// Returns "1 thing", "2 things".
[[nodiscard]] std::string counted(std::size_t count, const std::string& thing);

/// Returns "a, b and 3 more": at most so many names, the others counted.
[[nodiscard]] std::string some_of(const std::vector<std::string>& names, std::size_t named = 4);

/// Returns "joint 'a'", "joints 'a', 'b' and 3 more".
[[nodiscard]] std::string these(const std::string& what, const std::vector<std::string>& names);

}  // namespace thenar
