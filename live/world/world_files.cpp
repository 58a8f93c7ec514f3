#include "live/world/world_files.h"

#include <filesystem>
#include <memory>
#include <utility>

#include "api/named/portable_world.h"
#include "base/error.h"
#include "base/inside_folder.h"
#include "base/outside_path.h"
#include "data/io/world/named_parts.h"
#include "live/world/imported_files.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

/// Returns the world without hands and bodies.
std::shared_ptr<const WorldSpec> header_of(const WorldSpec& world) {
  WorldSpec header = world;
  header.hands.clear();
  header.bodies.clear();
  return std::make_shared<const WorldSpec>(std::move(header));
}

/// Returns the warnings about the bodies and hands of a world.
std::vector<std::string> load_warnings(const WorldState& state, const WorldSpec& world) {
  std::vector<std::string> warnings = missing_material_warnings(world);
  for (const StateHand& hand : state.hands)
    for (const std::string& warning : hand.built->hand.named.warnings)
      warnings.push_back(hand_name(state, hand) + ": " + warning);
  return warnings;
}

/// Checks the name of a file that a world is to be saved as. @return the name, normalised
/// @throws InputError if it is outside the working folder or does not end in .toml
std::string checked_target(const std::string& file) {
  std::string name = outside_path(file, OutsideUse::kInside);
  require(fs::path(name).extension() == ".toml", "wanted a file that ends in .toml, got '{}'",
          name);
  return name;
}

/// Returns true if the world was loaded from or saved to a file. @param target  canonical path
bool is_file_of(const LiveWorld& live, const fs::path& target) {
  std::error_code failed;
  const std::string& own = live.state().file;
  return !own.empty() && fs::weakly_canonical(own, failed) == target && !failed;
}

/// @throws InputError if saving would overwrite a file other than the world's own
void require_free(const LiveWorld& live, const InsideFolder& folder, const std::string& name) {
  require(
      folder.entry(name) != InsideFolder::Entry::kFile || is_file_of(live, folder.path_of(name)),
      "'{}' is there already and is not of this world: 'overwrite' replaces it", name);
}

}  // namespace

WorldState state_of_world(LiveWorld& live, const WorldSpec& world, const std::string& path,
                          const Progress& progress) {
  WorldState state;
  state.header = header_of(world);
  state.placed = world.hands;
  const std::vector<std::string> data = data_for(world.folder, live.folders().data);
  // Build the bodies first, because errors in them are found quickly.
  for (const PlacedBody& placed : world.bodies) state.bodies.push_back(build_state_body(placed));
  // Build each hand that carries no other, with all its carriers.
  for (std::size_t i = 0; i < world.hands.size(); ++i) {
    if (!carried_by(world.hands, world.hands[i].name).empty()) continue;
    std::shared_ptr<const LiveHand> built = live.find_or_build_hand(world, i, path, progress);
    const WorldHand in_world = reposed_hand(world, world.hands[i].name, path, data, built->hand);
    state.hands.push_back({std::move(built), in_world.parts, {in_world.X_WH, in_world.q}});
  }
  return state;
}

void new_world(LiveWorld& live) {
  live.apply(empty_world("untitled", live.folders().folder), "new world");
}

std::vector<std::string> load_world(LiveWorld& live, const std::string& world,
                                    const Progress& progress) {
  WorldRequest request;
  request.world = world;
  request.data = live.folders().data;
  // Read and build the new world before the current one is replaced.
  const std::string file = world_file(request);
  const WorldSpec spec = read_world_at(file, live.folders().data);
  WorldState state = state_of_world(live, spec, file, progress);
  state.file = file;
  // Replace the world.
  std::vector<std::string> warnings = load_warnings(state, spec);
  live.apply(std::move(state), "load " + spec.name);
  live.mark_saved(file);
  return warnings;
}

std::vector<std::string> load_world_text(LiveWorld& live, const std::string& text,
                                         const std::string& name, const Progress& progress) {
  // Check that the name, which comes from a client, does not lead out of the folder.
  const fs::path file = outside_path(name + ".toml", OutsideUse::kInside);
  const std::string path = (fs::path(live.folders().folder) / file).string();
  const WorldSpec spec =
      parse_world(text, path, data_for(live.folders().folder, live.folders().data));
  WorldState state = state_of_world(live, spec, path, progress);
  std::vector<std::string> warnings = load_warnings(state, spec);
  live.apply(std::move(state), "load " + spec.name);
  return warnings;
}

std::string world_text(const LiveWorld& live) {
  const WorldSpec world = world_spec(live.state());
  for (const PlacedHand& hand : world.hands)
    require(imported_hand_file(live, hand).empty(),
            "the files of the hand '{}' were imported, and no text holds them: save the world, "
            "which writes them beside it, and load what was saved",
            hand.name);
  return world_toml(with_shipped_names(world, live.folders().folder));
}

std::string save_live_world(LiveWorld& live, const std::string& file, Overwrite over) {
  // Check the name, and that no other file would be overwritten.
  const std::string name = checked_target(file);
  const InsideFolder folder(live.folders().folder);
  if (over == Overwrite::kNothing) require_free(live, folder, name);
  folder.require_writable(name);
  // Write the copies of files, then the world.
  const std::string target = folder.path_of(name);
  const PortableWorld portable =
      portable_world(world_spec(live.state()), target, imported_folders(live));
  write_copies(portable, folder);
  folder.write(name, world_toml(portable.world));
  live.mark_saved(target);
  return target;
}

}  // namespace thenar
