#include "data/io/mesh/repair_shape.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_parts.h"
#include "geometry/repair_to_solid.h"

namespace thenar {
namespace {

/// Description of a mesh: "mesh 'palm.stl' of link 'palm'".
std::string described(const ShapeSpec& shape, const std::string& owner) {
  if (shape.mesh_file.empty()) return "a mesh of " + owner;
  return fmt::format("mesh '{}' of {}", std::filesystem::path(shape.mesh_file).filename().string(),
                     owner);
}

}  // namespace

bool repair_shape(ShapeSpec& shape, const std::string& owner, std::vector<std::string>& warnings) {
  if (shape.kind != ShapeKind::kMesh) return true;
  try {
    // Closed meshes stay as they are.
    RepairedSolid mended = repair_to_solid(shape.mesh);
    if (mended.done.empty()) return true;
    warnings.push_back(fmt::format("MENDED {}: {}", described(shape, owner), mended.done));
    // The repaired mesh is no longer that of its file.
    shape.mesh = std::move(mended.mesh);
    shape.mesh_file.clear();
    shape.mesh_scale = 1;
  } catch (const InputError& error) {
    warnings.push_back(fmt::format("LEFT OUT {}: {}", described(shape, owner), error.what()));
    return false;
  }
  return true;
}

void repair_shapes(std::vector<ShapeSpec>& shapes, const std::string& owner,
                   std::vector<std::string>& warnings) {
  std::vector<ShapeSpec> kept;
  for (ShapeSpec& shape : shapes)
    if (repair_shape(shape, owner, warnings)) kept.push_back(std::move(shape));
  shapes = std::move(kept);
}

void note_turned(const std::vector<ShapeSpec>& shapes, const std::string& owner,
                 std::vector<std::string>& warnings) {
  for (const ShapeSpec& shape : shapes) {
    if (shape.kind != ShapeKind::kMesh) continue;
    const int edges = check_mesh(shape.mesh).reversed_edges;
    if (edges > 0)
      warnings.push_back(fmt::format(
          "{}: {} edges lie between triangles that face opposite ways; they are turned to agree, "
          "and `thenar import` with repairs writes them so",
          described(shape, owner), edges));
  }
}

void require_solid(const ShapeSpec& shape, const std::string& owner) {
  if (shape.kind != ShapeKind::kMesh) return;
  try {
    (void)solid_parts(shape.mesh);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", described(shape, owner), error.what()));
  }
}

}  // namespace thenar
