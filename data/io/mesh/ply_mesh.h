#pragma once

#include <string>

#include "data/io/mesh/polygons.h"

namespace thenar {

/// The vertices and faces (or strips of triangles) of a PLY, in text or in bytes of either order;
/// other elements and properties are passed over.
/// @param path  names the file in messages
/// @throws DataError at the line of the header that is wrong or promises more than the file can
/// hold; at the line of text that is wrong; at line 1 if bytes are missing.
[[nodiscard]] Polygons parse_ply(const std::string& text, const std::string& path);

}  // namespace thenar
