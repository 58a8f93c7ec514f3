#include "data/io/world/world.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/toml_text.h"
#include "data/io/world/body_toml.h"
#include "data/io/world/named_parts.h"
#include "data/io/world/world_keys.h"
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

PlacedHand read_hand(TomlTable& table, const WorldSpec& world,
                     const std::vector<std::string>& places) {
  PlacedHand hand;
  hand.name = table.text("name");
  if (table.has("file"))
    hand.file = internal::file_or_name(table, "file", world.folder, {"robots", "subjects"}, places);
  hand.X_WH = read_pose_keys(table);
  hand.posture = internal::read_posture(table);
  hand.carrier = table.text_or("carrier", "");
  hand.carrier_link = hand.carrier.empty() ? "" : table.text("carrier_link");
  return hand;
}

PlacedBody read_body(TomlTable& table, const WorldSpec& world, const std::string& path,
                     const std::vector<std::string>& places) {
  const bool dynamic = table.choice("role", {"object", "obstacle"}) == "object";
  PlacedBody placed = internal::read_placed_body(table, path, world.materials, places);
  placed.dynamic = dynamic;
  return placed;
}

/// Checks that names are unique, and that hands are carried by other hands that exist.
void check_names(TomlTable& top, const WorldSpec& world) {
  std::vector<std::string> bodies, hands = names_of(world.hands);
  for (const PlacedBody& placed : world.bodies) bodies.push_back(placed.body.name);
  for (std::vector<std::string> names : {bodies, hands}) {
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) top.fail(fmt::format("two things are called '{}'", *twice));
  }
  for (const PlacedHand& hand : world.hands)
    if (!hand.carrier.empty() && (hand.carrier == hand.name || !contains(hands, hand.carrier)))
      top.fail(fmt::format("'{}' is carried by '{}', which is not another hand or arm here",
                           hand.name, hand.carrier));
}

}  // namespace

WorldSpec parse_world(const std::string& text, const std::string& path,
                      const std::vector<std::string>& places) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  // Header and materials.
  WorldSpec world;
  world.folder = std::filesystem::path(path).parent_path().string();
  world.name = top.text("name");
  world.description = top.text_or("description", "");
  world.source = top.source();
  world.own_sources = file.own_sources();
  world.materials_file = top.text_or("materials", "");
  world.materials = internal::read_materials_key(top, world.folder);
  // Camera, hands and bodies.
  world.camera = internal::read_camera(top);
  read_each(top, "hand", world.hands, read_hand, world, places);
  read_each(top, "body", world.bodies, read_body, world, path, places);
  top.done();
  check_names(top, world);
  return world;
}

WorldSpec parse_world(const std::string& text, const std::string& path) {
  return parse_world(text, path, {});
}

WorldSpec read_world(const std::string& path) { return read_world(path, {}); }

WorldSpec read_world(const std::string& path, const std::vector<std::string>& places) {
  WorldSpec world = parse_world(read_text_file(path), path, places);
  world.files = digests_of({path});
  if (!world.materials_file.empty())
    world.files.merge(
        digests_of({(std::filesystem::path(world.folder) / world.materials_file).string()}));
  world.files.insert(world.materials.files.begin(), world.materials.files.end());
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
  // Largest relative error of a volume that gives a mass [1]
  constexpr double kMaxVolumeError = 0.01;
  // Mass of the union at unit density.
  const UnionMass found = union_mass(body.shapes);
  const MassProperties& even = found.mass;
  require(even.mass > 0, "the shapes of body '{}' enclose nothing", body.name);
  require(found.error <= kMaxVolumeError,
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
