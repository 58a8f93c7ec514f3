#include "data/io/mesh/stl_copy.h"

#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file_io.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/triangle_soup.h"
#include "geometry/mesh_parts.h"
#include "geometry/repair_to_solid.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

std::string normal_path(const fs::path& path) {
  return fs::absolute(path).lexically_normal().string();
}

/// A mesh that bounds as many solids when it is read from an STL file, mended where rounding opens
/// it; empty if there is none.
TriangleMesh lasting_in_stl(TriangleMesh mesh) {
  constexpr int kMaxMendRounds = 3;  // Most rounds of rounding and mending
  const std::size_t solids = solids_or_none(mesh).size();
  if (solids == 0) return {};
  try {
    for (int round = 0; round < kMaxMendRounds; ++round) {
      TriangleMesh rounded = as_in_stl(mesh);
      if (solids_or_none(rounded).size() == solids) return mesh;
      mesh = repair_to_solid(rounded).mesh;
    }
  } catch (const Error&) {
    return {};  // nothing is left of it in single precision
  }
  return {};
}

}  // namespace

TriangleMesh as_in_stl(const TriangleMesh& mesh) {
  const std::string name = "mesh.stl";
  return weld_vertices(parse_stl(mesh_bytes(name, mesh), name), 1, name);
}

void StlFiles::leave(const std::vector<ShapeSpec>& shapes) {
  const fs::path folder = fs::path(out_).parent_path();
  for (const ShapeSpec& shape : shapes)
    if (!shape.mesh_file.empty()) taken_.insert(normal_path(folder / shape.mesh_file));
}

void StlFiles::give(std::vector<ShapeSpec>& shapes, const std::string& owner) {
  const fs::path folder = fs::path(out_).parent_path();
  const std::string stem = fs::path(out_).stem().string();
  for (ShapeSpec& shape : shapes) {
    if (shape.kind != ShapeKind::kMesh || !shape.mesh_file.empty()) continue;
    const TriangleMesh mesh = lasting_in_stl(shape.mesh);
    if (mesh.empty()) continue;
    // The first number that is free.
    std::string name, path;
    int number = 0;
    do {
      name = plain_file_name(fmt::format("{}_{}_{}.stl", stem, owner, number++));
      path = (folder / name).string();
    } while (!taken_.insert(normal_path(path)).second);
    files_.emplace_back(path, mesh_bytes(path, mesh));
    shape.mesh_file = name;
    shape.mesh_scale = 1;
  }
}

void StlFiles::write(const std::string& text) {
  files_.emplace_back(out_, text);
  write_files(files_);
}

}  // namespace thenar
