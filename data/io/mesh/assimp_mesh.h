#pragma once

#include <string>

#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// The triangles of an OBJ, PLY, OFF, glTF or GLB, in single precision, placed by the file's
/// own scene graph. @throws DataError if the file is none of these, or broken.
[[nodiscard]] TriangleSoup read_assimp_mesh(const std::string& path);

}  // namespace thenar
