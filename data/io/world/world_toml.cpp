#include <fmt/format.h>

#include "data/io/mesh/shape_toml.h"
#include "data/io/toml_text.h"
#include "data/io/world/body_toml.h"

namespace thenar {
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

}  // namespace thenar
