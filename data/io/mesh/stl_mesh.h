#pragma once

#include <string>

#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// The triangles of an STL, in bytes or as text. Text may stand in any case and on any lines, and
/// hold several solids; bytes may be followed by others, and their heading begin with "solid".
/// @param path  names the file in messages
/// @throws DataError if it is neither, is cut off, or a number is none.
[[nodiscard]] TriangleSoup parse_stl(const std::string& text, const std::string& path);

}  // namespace thenar
