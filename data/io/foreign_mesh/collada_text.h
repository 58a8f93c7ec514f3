#pragma once

#include <string>

namespace thenar {

/// Refuses a Collada on which assimp would never come to an end or read beyond its numbers: no well
/// formed XML, lists of whole numbers (<p>, <vcount>..) that hold anything else, <accessor>s that
/// reach beyond their <float_array>; nor one that names other files, or whose nodes stand in
/// themselves or for more than 100,000.
/// @param path  names the file in messages
/// @throws DataError at the first line that is wrong.
void check_collada(const std::string& text, const std::string& path);

}  // namespace thenar
