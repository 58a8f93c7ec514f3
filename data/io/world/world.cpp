#include "data/io/world/world.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/nearest_name.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/toml_text.h"
#include "data/io/world/body_toml.h"
#include "geometry/shape_mass.h"

namespace thenar {

BodySpec parse_object(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  BodySpec body = internal::read_body_keys(top, path);
  top.done();
  return body;
}

BodySpec read_object(const std::string& path) {
  BodySpec body = parse_object(read_text_file(path), path);
  body.files = mesh_files(body.shapes, path);
  body.files.merge(digests_of({path}));
  return body;
}

std::string object_toml(const BodySpec& body) {
  BodySpec sourced = body;
  if (sourced.source.empty()) sourced.source = "Unstated";
  const std::string lines = internal::body_lines(sourced, "");
  const std::size_t shapes = lines.find("\n[[shape]]");
  return internal::text_line("name", body.name) + lines.substr(0, shapes) +
         internal::sources_table({sourced.source}, {}) + lines.substr(shapes);
}

namespace {

/// Path of a file named in a world, relative to the working directory.
std::string found(TomlTable& table, const std::string& key, const WorldSpec& world) {
  std::string path =
      (std::filesystem::path(world.folder) / table.text(key)).lexically_normal().string();
  if (!is_file(path)) table.fail(fmt::format("there is no file '{}'", path), key);
  return path;
}

/// Reads a posture: joint angles, positions of sliding joints, or either in SI as the writer states
/// it.
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

/// Reads a body from a file; the world may change its name and material.
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
  if (placed.file.empty()) placed.body.files = mesh_files(placed.body.shapes, path);
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

/// Checks that names are unique, and that hands are carried by other hands that exist.
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
  // Header and materials.
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
  // Camera, hands and bodies.
  read_camera(top, world.camera);
  for (TomlTable& table : top.tables("hand")) world.hands.push_back(read_hand(table, world));
  for (TomlTable& table : top.tables("body")) world.bodies.push_back(read_body(table, world, path));
  top.done();
  check_names(top, world);
  return world;
}

WorldSpec read_world(const std::string& path) {
  WorldSpec world = parse_world(read_text_file(path), path);
  world.files = digests_of({path});
  if (!world.materials_file.empty())
    world.files.merge(
        digests_of({(std::filesystem::path(world.folder) / world.materials_file).string()}));
  for (const PlacedBody& placed : world.bodies)
    world.files.insert(placed.body.files.begin(), placed.body.files.end());
  return world;
}

namespace {

using internal::text_line;

std::string pose_lines(const Pose<double>& X) {
  std::string text;
  for (const std::string& line : toml_of(X)) text += line + "\n";
  return text;
}

std::string posture_line(const PlacedHand& hand) {
  std::vector<std::string> entries;
  for (const auto& [name, value] : hand.posture)
    entries.push_back(fmt::format("{} = {}", toml_quoted(name), toml_number(value)));
  return entries.empty() ? "" : fmt::format("posture_si = {{{}}}\n", fmt::join(entries, ", "));
}

std::string hand_table(const PlacedHand& hand) {
  return "\n[[hand]]\n" + text_line("name", hand.name) + text_line("file", hand.file) +
         pose_lines(hand.X_WH) + posture_line(hand) + text_line("carrier", hand.carrier) +
         text_line("carrier_link", hand.carrier_link);
}

std::string body_table(const PlacedBody& placed) {
  const BodySpec& body = placed.body;
  std::string text = fmt::format("\n[[body]]\nrole = \"{}\"\nname = {}\n",
                                 placed.dynamic ? "object" : "obstacle", toml_quoted(body.name));
  text += text_line("file", placed.file) + pose_lines(placed.X_WB);
  return text + (placed.file.empty() ? internal::body_lines(body, "body.")
                                     : text_line("material", body.material));
}

std::string camera_table(const Camera& camera) {
  return fmt::format("\n[camera]\neye_m = {}\ntarget_m = {}\n", toml_list(camera.eye),
                     toml_list(camera.target));
}

}  // namespace

std::string world_toml(const WorldSpec& world) {
  // Sources of the world and of bodies that are written out.
  std::vector<std::string> sources{world.source};
  for (const PlacedBody& placed : world.bodies)
    if (placed.file.empty() && !placed.body.source.empty()) sources.push_back(placed.body.source);
  std::string text =
      "name = " + toml_quoted(world.name) + "\n" + text_line("description", world.description) +
      internal::source_line(world.source) + text_line("materials", world.materials_file) +
      internal::sources_table(sources, world.own_sources) + camera_table(world.camera);
  for (const PlacedHand& hand : world.hands) text += hand_table(hand);
  for (const PlacedBody& placed : world.bodies) text += body_table(placed);
  return text;
}

namespace {

/// Density of a body [kg/m^3], by which its mass at unit density is multiplied. @param volume [m^3]
double density_of(const BodySpec& body, double volume, const Materials& materials) {
  if (body.uniform_mass > 0) return body.uniform_mass / volume;
  const double density = body.density > 0 || body.material.empty()
                             ? body.density
                             : materials.at(body.material).density;
  require(density > 0,
          "body '{}' has neither mass nor density, nor has its material '{}': state mass_g or "
          "density_kg_m3 beside its shapes, in its object file or its [[body]] of the world",
          body.name, body.material);
  return density;
}

}  // namespace

BodyMass body_mass(const BodySpec& body, const Materials& materials) {
  if (body.mass) return *body.mass;
  constexpr double kKnown = 0.01;  // largest relative error of a volume that gives a mass
  // Mass of the union at unit density.
  const UnionMass found = union_mass(body.shapes);
  const MassProperties& even = found.mass;
  require(even.mass > 0, "the shapes of body '{}' enclose nothing", body.name);
  require(found.error <= kKnown,
          "the volume of body '{}' is known to {:.0f} % only, so many of its parts overlap: state "
          "mass, com and inertia, or join the parts into one surface",
          body.name, 100 * found.error);
  // Scaled by the density.
  BodyMass result{even.mass, even.centre, even.inertia};
  const double density = density_of(body, result.mass, materials);
  result.mass *= density;
  result.inertia *= density;
  return result;
}

}  // namespace thenar
