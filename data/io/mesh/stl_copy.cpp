#include "data/io/mesh/stl_copy.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
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

/// A name that is a valid file name everywhere.
std::string file_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return std::isalnum(c) == 0 && c != '.' && c != '-'; }, '_');
  return name;
}

/// Number of solids that a mesh bounds; 0: it is none.
std::size_t solids_in(const TriangleMesh& mesh) {
  try {
    return solid_parts(mesh).size();
  } catch (const InputError&) {
    return 0;
  }
}

/// A mesh that bounds as many solids when it is read from an STL file, mended where rounding opens
/// it; empty if there is none.
TriangleMesh lasting_in_stl(TriangleMesh mesh) {
  constexpr int kRounds = 3;  // of rounding and mending
  const std::size_t solids = solids_in(mesh);
  if (solids == 0) return {};
  try {
    for (int round = 0; round < kRounds; ++round) {
      TriangleMesh rounded = as_in_stl(mesh);
      if (solids_in(rounded) == solids) return mesh;
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

WrittenFiles give_stl_files(std::vector<ShapeSpec>& shapes, const std::string& out,
                            const std::string& owner, std::set<std::string>& taken) {
  WrittenFiles files;
  const fs::path folder = fs::path(out).parent_path();
  const std::string stem = fs::path(out).stem().string();
  for (ShapeSpec& shape : shapes) {
    if (shape.kind != ShapeKind::kMesh || !shape.mesh_file.empty()) continue;
    const TriangleMesh mesh = lasting_in_stl(shape.mesh);
    if (mesh.empty()) continue;
    // The first number that is free.
    std::string name, path;
    int number = 0;
    do {
      name = file_name(fmt::format("{}_{}_{}.stl", stem, owner, number++));
      path = (folder / name).string();
    } while (!taken.insert(normal_path(path)).second);
    files.emplace_back(path, mesh_bytes(path, mesh));
    shape.mesh_file = name;
    shape.mesh_scale = 1;
  }
  return files;
}

void add_mesh_paths(const std::vector<ShapeSpec>& shapes, const std::string& folder,
                    std::set<std::string>& paths) {
  for (const ShapeSpec& shape : shapes)
    if (!shape.mesh_file.empty()) paths.insert(normal_path(fs::path(folder) / shape.mesh_file));
}

}  // namespace thenar
