#pragma once

#include <string>

#include "data/io/mesh/polygons.h"

namespace thenar {

/// The vertices and faces of a Wavefront OBJ. Materials, textures, normals, lines and all else are
/// passed over: no other file is opened, whatever `mtllib` names.
/// @param path  names the file in messages
/// @throws DataError at the line of a vertex or face that is none.
[[nodiscard]] Polygons parse_obj(const std::string& text, const std::string& path);

}  // namespace thenar
