#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "data/io/mesh/assimp_mesh.h"
#include "data/io/mesh/inventor_mesh.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/stl_mesh.h"
#include "data/io/mesh/triangle_soup.h"
#include "data/io/toml_node.h"

namespace thenar {

TriangleMesh read_mesh(const std::string& path, double scale) {
  require(scale > 0 && std::isfinite(scale), "a mesh is scaled by a number > 0, got {}", scale);
  const MeshFormat format = mesh_format(path);
  if (!std::filesystem::is_regular_file(path)) throw DataError(path, 1, "cannot be opened");
  const bool inventor = format == MeshFormat::kVrml || format == MeshFormat::kInventor;
  if (format == MeshFormat::kStl)
    return merge_corners(parse_stl(read_text_file(path), path), scale, path);
  return merge_corners(inventor ? read_inventor_mesh(path) : read_assimp_mesh(path), scale, path);
}

}  // namespace thenar
