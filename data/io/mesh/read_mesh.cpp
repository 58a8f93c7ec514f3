#include <cmath>

#include "base/error.h"
#include "data/io/file_guard.h"
#include "data/io/mesh/foreign_mesh.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/obj_mesh.h"
#include "data/io/mesh/off_mesh.h"
#include "data/io/mesh/placed_primitive.h"
#include "data/io/mesh/ply_mesh.h"
#include "data/io/mesh/stl_mesh.h"
#include "data/io/mesh/triangle_soup.h"

namespace thenar {
namespace {

TriangleSoup read_soup(const std::string& path, MeshTime& left) {
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
  return read_foreign_mesh(path, mesh_format(path), left);
}

MeshContent read_in(const std::string& path, double scale, MeshTime& left) {
  require(scale > 0 && std::isfinite(scale), "a mesh is scaled by a number > 0, got {}", scale);
  const TriangleSoup soup = read_soup(path, left);
  MeshContent content{merge_corners(soup, scale, path), {}};
  for (const ShapeSpec& shape : soup.exact) content.exact.push_back(scaled_primitive(shape, scale));
  return content;
}

}  // namespace

TriangleMesh read_mesh(const std::string& path, double scale) {
  return read_mesh_content(path, scale).mesh;
}

MeshContent read_mesh_content(const std::string& path, double scale) {
  MeshTime time;
  return read_in(path, scale, time);
}

const MeshContent& MeshReader::content(const std::string& path, double scale) {
  const auto key = std::make_pair(path, scale);
  if (const auto failed = failures_.find(key); failed != failures_.end()) throw failed->second;
  auto found = contents_.find(key);
  try {
    if (found == contents_.end()) found = contents_.emplace(key, read_in(path, scale, left_)).first;
    if (found->second.mesh.triangles.cols() > kMostTogether - triangles_)
      throw DataError(path, 1,
                      fmt::format("is not read: with it the meshes of one file have more than {} "
                                  "triangles",
                                  kMostTogether));
  } catch (const DataError& error) {
    failures_.emplace(key, error);
    throw;
  }
  triangles_ += found->second.mesh.triangles.cols();
  return found->second;
}

}  // namespace thenar
