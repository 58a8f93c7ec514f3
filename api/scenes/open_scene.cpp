#include "api/scenes/open_scene.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "api/named/data_folders.h"
#include "api/named/files.h"
#include "api/named/hands.h"
#include "api/named/portable_world.h"
#include "api/named/things.h"
#include "api/named/worlds.h"
#include "base/error.h"
#include "base/nearest_name.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

constexpr int kDrawnSkin = 1200;  // triangles of the picture of each link of a human hand, at most

/// Finds the data from which a hand is built, by its file or name.
/// @param path   of tendons of a human hand that states none
/// @param files  receives the files that were read for it
SceneHand hand_of(const SceneSpec& scene, const SceneHandSpec& hand,
                  const std::optional<Path>& path, const std::vector<std::string>& places,
                  FileDigests& files) {
  // The name of a hand, or the path of its file beside the scene, with the version at its end.
  std::string name = hand.placed.file.empty()
                         ? hand.placed.name
                         : (fs::path(scene.folder) / hand.placed.file).string();
  if (!hand.version.empty()) name += ":" + hand.version;
  const HandSource source = at_line(scene.path, hand.line, [&] { return find_hand(name, places); });
  // A robot: options of skins are errors, and the file must hold a robot.
  if (!source.human) {
    if (hand.skin_triangles > 0 || hand.skin_capsules || hand.passive)
      throw DataError(scene.path, hand.line,
                      fmt::format("'{}' is not a human hand with a skin", name));
    Thing thing = read_thing(source.file);
    auto* robot = std::get_if<RobotSpec>(&thing);
    if (robot == nullptr)
      throw DataError(scene.path, hand.line, fmt::format("'{}' is not a robot", source.file));
    files.insert(robot->files.begin(), robot->files.end());
    return std::move(*robot);
  }
  // A human hand: the version, paths and skin of the scene.
  HumanModel human{source.file.empty() ? default_human() : read_subject(source.file),
                   *source.version};
  human.options.path = source.path ? source.path : path;
  human.options.passive = hand.passive.value_or(true) ? source.passive : PassiveMoments::kOff;
  human.options.skin.drawn = kDrawnSkin;
  if (hand.skin_triangles > 0) human.options.skin.triangles = hand.skin_triangles;
  human.options.skin.capsules = hand.skin_capsules.value_or(false);
  if (!source.file.empty()) files.merge(digests_of({source.file}));
  return human;
}

/// Returns the texts of descriptions and tables among the files.
std::vector<SourceText> texts_of(const std::string& scene, const FileDigests& files) {
  std::vector<SourceText> sources{read_source(scene)};
  const std::string first = fs::path(scene).lexically_normal().string();
  for (const auto& [path, digest] : files)
    if (const fs::path ending = fs::path(path).extension();
        path != first && (ending == ".toml" || ending == ".csv"))
      sources.push_back(read_source(path));
  return sources;
}

}  // namespace

bool is_scene(const std::string& name_or_path, const std::string& data) {
  // A name counts as a scene only if no subject has it; a file is looked into.
  std::error_code none;
  if (!fs::exists(name_or_path, none)) {
    const std::vector<std::string> places = data_folders(data);
    return find_in(places, "subjects/" + name_or_path + ".toml").empty() &&
           !find_in(places, "scenes/" + name_or_path + ".toml").empty();
  }
  try {
    return contents_of(name_or_path).kind == "scene";
  } catch (const DataError&) {
    return false;  // the reader reports the error
  }
}

std::vector<SceneHand> hands_of_scene(const SceneSpec& scene, const std::string& data,
                                      FileDigests& files, const std::optional<Path>& path) {
  const std::vector<std::string> places = data_for(scene.folder, data);
  std::vector<SceneHand> hands;
  for (const SceneHandSpec& hand : scene.hands)
    hands.push_back(hand_of(scene, hand, path, places, files));
  return hands;
}

OpenScene open_scene(const SceneSpec& scene, const std::string& data,
                     const std::optional<Path>& path) {
  OpenScene out;
  out.files = scene.files;
  out.built = build_scene(scene, hands_of_scene(scene, data, out.files, path));
  if (!scene.files.empty()) out.sources = texts_of(scene.path, out.files);  // else: not of a file
  return out;
}

RequestedScene open_requested_scene(const SceneRequest& request) {
  const std::string file = requested_file("scene", "scene", request.scene, "scenes", request.data);
  return open_requested_scene(read_scene_at(file, request.data), request);
}

RequestedScene open_requested_scene(SceneSpec scene, const SceneRequest& request) {
  // Change what the request states.
  RequestedScene read{std::move(scene), {}, request};
  if (request.on_pins) read.spec.compliances.clear();
  if (!request.pads.empty()) {
    (void)index_of_name(request.pads, pad_rung_names(), "rung of pads", "pads");
    require_field("pads", !read.spec.pads.empty(), "'{}' has no [[pad]]", read.spec.name);
    for (ScenePadSpec& pad : read.spec.pads) pad.rung = request.pads;
  }
  // Options of the request replace those of the file.
  read.open = open_scene(read.spec, request.data, request.path);
  SceneOptions& options = read.open.built.options;
  // Method, duration and tolerance.
  options.method = request.method.value_or(options.method);
  options.duration = request.seconds.value_or(options.duration);
  options.sample_interval = request.sample.value_or(options.sample_interval);
  options.step_length = request.step.value_or(options.step_length);
  options.tolerance = request.tolerance.value_or(options.tolerance);
  require_field(request.sample ? "sample" : "seconds",
                options.duration / options.sample_interval <= kMaxSceneSamples,
                "wanted at most {:g} samples, got {:g} s in steps of {:g} s", kMaxSceneSamples,
                options.duration, options.sample_interval);
  return read;
}

}  // namespace thenar
