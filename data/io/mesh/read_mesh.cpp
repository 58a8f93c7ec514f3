#include <cmath>

#include "base/error.h"
#include "data/io/file_guard.h"
#include "data/io/mesh/foreign_mesh.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/obj_mesh.h"
#include "data/io/mesh/off_mesh.h"
#include "data/io/mesh/ply_mesh.h"
#include "data/io/mesh/stl_mesh.h"
#include "data/io/mesh/triangle_soup.h"

namespace thenar {
namespace {

TriangleSoup read_soup(const std::string& path) {
  const auto text = [&] { return read_guarded(path, GuardedKind::kMesh); };
  switch (mesh_format(path)) {
    case MeshFormat::kObj:
      return cut_polygons(parse_obj(text(), path), path);
    case MeshFormat::kStl:
      return parse_stl(text(), path);
    case MeshFormat::kPly:
      return cut_polygons(parse_ply(text(), path), path);
    case MeshFormat::kOff:
      return cut_polygons(parse_off(text(), path), path);
    case MeshFormat::kGltf:
    case MeshFormat::kCollada:
    case MeshFormat::kVrml:
    case MeshFormat::kInventor:
      break;
  }
  return read_foreign_mesh(path, mesh_format(path));
}

}  // namespace

TriangleMesh read_mesh(const std::string& path, double scale) {
  require(scale > 0 && std::isfinite(scale), "a mesh is scaled by a number > 0, got {}", scale);
  return merge_corners(read_soup(path), scale, path);
}

}  // namespace thenar
