#pragma once

#include <string>

#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// The triangles of a glTF, GLB or Collada, in single precision, placed by the file's
/// own scene graph. To be called once in a program, which opens nothing from then on.
/// @throws DataError if the file is none of these, or broken.
[[nodiscard]] TriangleSoup read_assimp_mesh(const std::string& path);

}  // namespace thenar
