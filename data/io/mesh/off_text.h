#pragma once

#include <string>

namespace thenar {

/// An OFF as the OBJ of the same surface: corners and polygons; colours and normals are left out.
/// assimp takes corners that do not exist for the first, so OFF goes this way round.
/// @param path  names the file in messages
/// @throws DataError at the line that is no OFF, or whose face has corners that do not exist.
[[nodiscard]] std::string off_as_obj(const std::string& text, const std::string& path);

}  // namespace thenar
