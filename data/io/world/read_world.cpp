#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/read_file.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/nearest_name.h"
#include "data/io/world/body_toml.h"

namespace thenar {
namespace {

/// A file named in a world, from where thenar runs.
std::string found(TomlTable& table, const std::string& key, const WorldSpec& world) {
  const std::string path =
      (std::filesystem::path(world.folder) / table.text(key)).lexically_normal().string();
  if (!is_file(path)) table.fail(fmt::format("there is no file '{}'", path), key);
  return path;
}

/// Joint angles, ways of sliding joints, or either in SI as the writer has it.
std::map<std::string, double> read_posture(TomlTable& table) {
  std::map<std::string, double> posture = table.named(Dimension::kNumber, "posture_si");
  for (const auto& [dimension, key] :
       {std::pair{Dimension::kAngle, "angles"}, std::pair{Dimension::kLength, "ways"}})
    for (const auto& [name, value] : table.named(dimension, key))
      if (!posture.emplace(name, value).second)
        table.fail(fmt::format("coordinate '{}' is given twice", name), key);
  return posture;
}

PlacedHand read_hand(TomlTable& table, const WorldSpec& world) {
  PlacedHand hand;
  hand.name = table.text("name");
  if (table.has("file")) {
    hand.file = table.text("file");
    (void)found(table, "file", world);
  }
  hand.X_WH = read_pose_keys(table);
  hand.posture = read_posture(table);
  hand.carrier = table.text_or("carrier", "");
  hand.carrier_link = hand.carrier.empty() ? "" : table.text("carrier_link");
  table.done();
  return hand;
}

/// A body of a file keeps what the file says, but for its name and material.
BodySpec read_filed_body(TomlTable& table, const std::string& file) {
  BodySpec body = read_object(file);
  body.name = table.text_or("name", body.name);
  body.material = table.text_or("material", body.material);
  return body;
}

void check_material(const TomlTable& table, const BodySpec& body, const Materials& materials) {
  std::vector<std::string> names;
  for (const Material& material : materials.materials) names.push_back(material.name);
  if (!body.material.empty() && std::find(names.begin(), names.end(), body.material) == names.end())
    table.fail(fmt::format("no material '{}'{}", body.material, did_you_mean(body.material, names)),
               "material");
}

PlacedBody read_body(TomlTable& table, const WorldSpec& world, const std::string& path) {
  PlacedBody placed;
  placed.dynamic = table.choice("role", {"object", "obstacle"}) == "object";
  placed.file = table.text_or("file", "");
  placed.body = placed.file.empty() ? internal::read_body_keys(table, path)
                                    : read_filed_body(table, found(table, "file", world));
  check_material(table, placed.body, world.materials);
  placed.X_WB = read_pose_keys(table);
  table.done();
  return placed;
}

OwnSources read_own_sources(const std::string& text, const std::string& path) {
  OwnSources own;
  const TomlNode top = parse_toml(text, path);
  if (const TomlNode* sources = top.find("sources"))
    for (const auto& [key, reference] : sources->members) own[key] = reference.text;
  return own;
}

void read_camera(TomlTable& top, Camera& camera) {
  std::optional<TomlTable> table = top.table("camera");
  if (!table) return;
  camera.eye = table->vector(Dimension::kLength, "eye");
  camera.target = table->vector(Dimension::kLength, "target");
  if ((camera.eye - camera.target).norm() < 1e-9)
    table->fail("wanted 'eye' apart from 'target'", "eye");
  table->done();
}

/// Names are told apart, and whoever is carried is carried by another.
void check_names(TomlTable& top, const WorldSpec& world) {
  std::vector<std::string> bodies, hands;
  for (const PlacedBody& placed : world.bodies) bodies.push_back(placed.body.name);
  for (const PlacedHand& hand : world.hands) hands.push_back(hand.name);
  for (std::vector<std::string> names : {bodies, hands}) {
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) top.fail(fmt::format("two things are called '{}'", *twice));
  }
  for (const PlacedHand& hand : world.hands)
    if (!hand.carrier.empty() &&
        (hand.carrier == hand.name ||
         std::find(hands.begin(), hands.end(), hand.carrier) == hands.end()))
      top.fail(fmt::format("'{}' is carried by '{}', which is no other hand or arm here", hand.name,
                           hand.carrier));
}

}  // namespace

WorldSpec parse_world(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  WorldSpec world;
  world.folder = std::filesystem::path(path).parent_path().string();
  world.name = top.text("name");
  world.description = top.text_or("description", "");
  world.source = top.source();
  world.own_sources = read_own_sources(text, path);
  if (top.has("materials")) {
    world.materials_file = top.text("materials");
    world.materials = read_materials(found(top, "materials", world), built_in_materials());
  }
  read_camera(top, world.camera);
  for (TomlTable& table : top.tables("hand")) world.hands.push_back(read_hand(table, world));
  for (TomlTable& table : top.tables("body")) world.bodies.push_back(read_body(table, world, path));
  top.done();
  check_names(top, world);
  return world;
}

WorldSpec read_world(const std::string& path) { return parse_world(read_text_file(path), path); }

}  // namespace thenar
