#include "api/simulate_scene.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/named/data_folders.h"
#include "api/named/files.h"
#include "api/named/hands.h"
#include "api/named/things.h"
#include "api/named/worlds.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/parallel_for.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

std::string scene_file(const SceneRequest& request) {
  std::string file =
      named_file("scene", request.scene, "scenes", ".toml", data_folders(request.data));
  require_kind(file, {"scene"});
  return file;
}

/// The robot of a hand, by its file or name.
RobotSpec robot_of(const SceneSpec& scene, const SceneHandSpec& hand,
                   const std::vector<std::string>& places) {
  const std::string file = hand.placed.file.empty()
                               ? robot_file(hand.placed.name, places)
                               : (fs::path(scene.folder) / hand.placed.file).string();
  if (file.empty())
    throw DataError(
        scene.path, hand.line,
        fmt::format("there is no robot '{}'{} (human hands cannot be simulated in "
                    "scenes yet)",
                    hand.placed.name, did_you_mean(hand.placed.name, names_in(places, "robots"))));
  Thing thing = read_thing(file);
  auto* robot = std::get_if<RobotSpec>(&thing);
  if (robot == nullptr)
    throw DataError(scene.path, hand.line, fmt::format("'{}' is no robot", file));
  return std::move(*robot);
}

/// Texts of the files that are texts.
std::vector<SourceText> texts_of(const std::string& scene, const FileDigests& files) {
  std::vector<SourceText> sources{read_source(scene)};
  const std::string first = fs::path(scene).lexically_normal().string();
  for (const auto& [path, digest] : files)
    if (path != first && fs::path(path).extension() == ".toml")
      sources.push_back(read_source(path));
  return sources;
}

/// A scene with what the request changes.
struct ReadScene {
  SceneSpec spec;
  OpenScene open;
};
ReadScene read_request(const SceneRequest& request) {
  ReadScene read{read_scene(scene_file(request)), {}};
  read.open = open_scene(read.spec, request.data);
  SceneOptions& options = read.open.built.options;
  if (!request.method.empty())
    options.method =
        static_cast<SteppingMethod>(index_of_name(request.method, stepping_names(), "method"));
  options.seconds = request.seconds.value_or(options.seconds);
  options.sample = request.sample.value_or(options.sample);
  options.step = request.step.value_or(options.step);
  options.tolerance = request.tolerance.value_or(options.tolerance);
  require(options.seconds / options.sample <= kMostSamples,
          "wanted at most {:g} samples, got {:g} s in steps of {:g} s", kMostSamples,
          options.seconds, options.sample);
  return read;
}

/// Simulates and measures a scene with some numbers changed.
SimulatedScene simulated(const ReadScene& read,
                         const std::vector<std::pair<std::string, double>>& numbers,
                         const Progress& progress) {
  SimulatedScene out;
  out.path = read.spec.path;
  out.name = read.spec.name;
  out.description = read.spec.description;
  out.camera = read.spec.camera;
  out.sources = read.open.sources;
  out.files = read.open.files;
  out.warnings = read.open.warnings;
  out.varied = numbers;
  auto built = std::make_shared<BuiltScene>(read.open.built);
  for (const auto& [name, value] : numbers) set_number(*built, name, value);
  out.run = simulate_scene(built->scene, built->options, progress);
  out.measures = measure_run(built->scene, out.run);
  out.built = std::move(built);
  return out;
}

/// The numbers of one run of a sweep; the last one varies fastest.
std::vector<std::pair<std::string, double>> numbers_of(const std::vector<SceneVariation>& vary,
                                                       std::size_t run) {
  std::vector<std::pair<std::string, double>> numbers(vary.size());
  for (std::size_t k = vary.size(); k-- > 0;) {
    const auto count = static_cast<std::size_t>(vary[k].count);
    numbers[k] = {vary[k].name, vary[k].value(static_cast<int>(run % count))};
    run /= count;
  }
  return numbers;
}

/// Runs in one sweep. @throws InputError if a variation is none, or there are too many
std::size_t count_runs(const std::vector<SceneVariation>& vary) {
  std::size_t runs = 1;
  std::set<std::string> names;
  for (const SceneVariation& each : vary) {
    require(each.count >= 1, "wanted at least one value of '{}', got {}", each.name, each.count);
    require(names.insert(each.name).second, "'{}' varies twice", each.name);
    require(static_cast<std::size_t>(each.count) <= kMostRuns / runs, "wanted at most {} runs",
            kMostRuns);
    runs *= static_cast<std::size_t>(each.count);
  }
  return runs;
}

/// Progress of several runs at once, told as one.
class SharedProgress {
 public:
  SharedProgress(const Progress& whole, std::size_t runs) : whole_(whole), done_(runs, 0) {}

  [[nodiscard]] Progress of(std::size_t run) {
    Progress part;
    part.stop_requested = [this] { return whole_.stop(); };
    part.report = [this, run](double fraction, const std::string& /*what*/) {
      const std::lock_guard<std::mutex> lock(told_);
      sum_ += fraction - done_[run];
      done_[run] = fraction;
      whole_(sum_ / static_cast<double>(done_.size()), "");
    };
    return part;
  }

 private:
  const Progress& whole_;
  std::mutex told_;
  std::vector<double> done_;
  double sum_ = 0;
};

}  // namespace

bool is_scene(const std::string& name_or_path, const std::string& data) {
  std::error_code none;
  if (!fs::exists(name_or_path, none)) {
    const std::vector<std::string> places = data_folders(data);
    return find_in(places, "subjects/" + name_or_path + ".toml").empty() &&
           !find_in(places, "scenes/" + name_or_path + ".toml").empty();
  }
  try {
    return contents_of(name_or_path).kind == "scene";
  } catch (const DataError&) {
    return false;  // its reader says what it wants
  }
}

OpenScene open_scene(const SceneSpec& scene, const std::string& data) {
  OpenScene out;
  const std::vector<std::string> places = data_for(scene.folder, data);
  std::vector<RobotSpec> robots;
  out.files = scene.files;
  for (const SceneHandSpec& hand : scene.hands) {
    robots.push_back(robot_of(scene, hand, places));
    out.files.insert(robots.back().files.begin(), robots.back().files.end());
  }
  out.built = build_scene(scene, robots);
  out.warnings = out.built.warnings;
  out.sources = texts_of(scene.path, out.files);
  return out;
}

SimulatedScene run_scene(const SceneRequest& request, const Progress& progress) {
  require(request.vary.empty(), "wanted one run, got numbers that vary");
  return simulated(read_request(request), {}, progress);
}

SceneSweep vary_scene(const SceneRequest& request, const Progress& progress) {
  const ReadScene read = read_request(request);
  SceneSweep sweep;
  sweep.path = read.spec.path;
  sweep.name = read.spec.name;
  sweep.vary = request.vary;
  sweep.files = read.open.files;
  sweep.warnings = read.open.warnings;
  sweep.asked = count_runs(request.vary);
  // Impossible values are refused before any work.
  for (std::size_t i = 0; i < sweep.asked; ++i) {
    BuiltScene trial = read.open.built;
    for (const auto& [name, value] : numbers_of(request.vary, i)) set_number(trial, name, value);
  }
  std::vector<std::optional<SimulatedScene>> runs(sweep.asked);
  SharedProgress shared(progress, sweep.asked);
  parallel_for(sweep.asked, [&](std::size_t i) {
    if (!progress.stop()) runs[i] = simulated(read, numbers_of(request.vary, i), shared.of(i));
  });
  for (std::optional<SimulatedScene>& run : runs)
    if (run) sweep.runs.push_back(std::move(*run));
  return sweep;
}

}  // namespace thenar
