#pragma once

#include <string>

namespace thenar {

/// Refuses a PLY whose header is broken, at which assimp may never come to an end.
/// @param path  names the file in messages
/// @return the text without comments before its line "format", where assimp wants none
/// @throws DataError at the first line of the header that is wrong.
[[nodiscard]] std::string format_first(std::string text, const std::string& path);

}  // namespace thenar
