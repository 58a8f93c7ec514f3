#include "data/io/world/world_keys.h"

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/outside_path.h"
#include "data/io/linked_file.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/world/body_toml.h"

namespace thenar::internal {
namespace {

/// Reads a body from a file; the table that names it may change its name and material.
BodySpec read_filed_body(TomlTable& table, const std::string& file) {
  BodySpec body = read_object(file);
  body.name = table.text_or("name", body.name);
  body.material = table.text_or("material", body.material);
  return body;
}

void check_material(const TomlTable& table, const BodySpec& body, const Materials& materials) {
  const std::vector<std::string> names = names_of(materials.materials);
  if (!body.material.empty() && !contains(names, body.material))
    table.fail(fmt::format("no material '{}'{}", body.material, did_you_mean(body.material, names)),
               "material");
}

}  // namespace

std::string file_beside(TomlTable& table, const std::string& key, const std::string& folder) {
  return linked_file(table, key, table.text(key), folder);
}

std::string file_or_name(TomlTable& table, const std::string& key, const std::string& folder,
                         const std::vector<std::string>& kinds,
                         const std::vector<std::string>& places) {
  namespace fs = std::filesystem;
  const std::string name = table.text(key);
  if (const auto fault = outside_fault(name, OutsideUse::kRead)) table.fail(*fault, key);
  const bool is_path = name.find_first_of("/.") != std::string::npos;
  if (is_path || places.empty() || is_file((fs::path(folder) / name).string())) {
    (void)file_beside(table, key, folder);
    return name;
  }
  for (const std::string& kind : kinds)
    for (const std::string& place : places)
      if (const fs::path file = fs::path(place) / kind / (name + ".toml"); is_file(file.string()))
        return fs::proximate(fs::absolute(file).lexically_normal(),
                             fs::absolute(folder.empty() ? "." : folder).lexically_normal())
            .generic_string();
  table.fail(fmt::format("'{}' is neither a file nor one of {}; looked in {}", name,
                         fmt::join(kinds, " and "), fmt::join(places, ", ")),
             key);
}

std::map<std::string, double> read_posture(TomlTable& table) {
  std::map<std::string, double> posture = table.named(Dimension::kNumber, "posture_si");
  for (const auto& [dimension, key] :
       {std::pair{Dimension::kAngle, "angles"}, std::pair{Dimension::kLength, "ways"}})
    for (const auto& [name, value] : table.named(dimension, key))
      if (!posture.emplace(name, value).second)
        table.fail(fmt::format("coordinate '{}' is given twice", name), key);
  return posture;
}

PlacedBody read_placed_body(TomlTable& table, const std::string& path, const Materials& materials,
                            const std::vector<std::string>& places) {
  PlacedBody placed;
  const std::string folder = std::filesystem::path(path).parent_path().string();
  if (table.has("file")) {
    placed.file = file_or_name(table, "file", folder, {"objects"}, places);
    placed.body = read_filed_body(
        table, (std::filesystem::path(folder) / placed.file).lexically_normal().string());
  } else {
    placed.body = read_body_keys(table, path);
  }
  if (placed.file.empty()) placed.body.files = mesh_files(placed.body.shapes, path);
  check_material(table, placed.body, materials);
  placed.X_WB = read_pose_keys(table);
  return placed;
}

Materials read_materials_key(TomlTable& top, const std::string& folder) {
  return top.has("materials")
             ? read_materials(file_beside(top, "materials", folder), built_in_materials())
             : built_in_materials();
}

Camera read_camera(TomlTable& top) {
  Camera camera;
  std::optional<TomlTable> table = top.table("camera");
  if (!table) return camera;
  camera.eye = table->vector(Dimension::kLength, "eye");
  camera.target = table->vector(Dimension::kLength, "target");
  if ((camera.eye - camera.target).norm() < 1e-9)
    table->fail("wanted 'eye' apart from 'target'", "eye");
  table->done();
  return camera;
}

}  // namespace thenar::internal
