#pragma once

#include <string>

#include "data/io/mesh/polygons.h"

namespace thenar {

/// The vertices and faces of an OFF in text; colours and normals are left out.
/// @param path  names the file in messages
/// @throws DataError at the line that is no OFF, that promises more than the file can hold, or
/// whose face has corners that do not exist.
[[nodiscard]] Polygons parse_off(const std::string& text, const std::string& path);

}  // namespace thenar
