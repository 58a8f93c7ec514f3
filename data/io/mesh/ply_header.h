#pragma once

#include <string>

namespace thenar {

/// Refuses a PLY whose header is broken, at which assimp may never come to an end.
/// @param path  names the file in messages
/// @throws DataError at the first line of the header that is wrong.
void check_ply_header(const std::string& text, const std::string& path);

}  // namespace thenar
