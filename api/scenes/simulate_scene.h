#pragma once

/// Simulation of a scene of bodies and hands.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/fidelity.h"
#include "base/progress.h"
#include "base/provenance.h"
#include "base/run_record.h"
#include "dynamics/scene/build_scene.h"
#include "dynamics/scene/measure_run.h"
#include "solvers/status.h"

namespace thenar {

/// Number of a scene that varies from run to run; names and units as in set_number().
struct SceneVariation {
  std::string name;
  double from = 0, to = 0;
  int count = 1;  // number of values, evenly spaced, including both ends

  [[nodiscard]] double value(int i) const {
    return count == 1 ? from : from + (to - from) * i / (count - 1);
  }
};

/// Options of a scene's simulation; absent values are taken from the scene's file.
struct SceneRequest {
  std::string scene;  // file, or name of one of scenes/
  std::string data;   // folder with scenes/, robots/ ..; empty: the usual ones
  std::string method;
  std::string pads;                  // rung of all its [[pad]], of pad_rung_names()
  std::optional<Path> path = {};     // tendon paths of human hands that state none; absent:
                                     // default_path()
  bool on_pins = false;              // ignore [[compliance]]: every joint is rigid
  std::optional<double> seconds;     // duration [s]
  std::optional<double> sample;      // time between stored instants [s]
  std::optional<double> step;        // fixed step size [s]
  std::optional<double> tolerance;   // error of a step [m] or [rad]
  std::vector<SceneVariation> vary;  // the last one varies fastest; empty: one run
};

/// Result of a simulated scene.
struct [[nodiscard]] SceneResult {
  SceneRequest request;
  Outcome outcome;  // stalled: do not use it, see run.status
  std::string name, description;
  std::optional<Camera> camera;
  std::shared_ptr<const BuiltScene> built;  // simulated scene with its assumptions; never null
  std::vector<std::pair<std::string, double>> varied;  // numbers that differ from the file
  SceneRun run;
  RunMeasures measures;
  std::vector<SourceText> sources;  // scene, hands, objects, materials; meshes are in `files` only
  FileDigests files;                // digests of all files that were read
};

/// Returns true if the scene's method solves contact problems; compliant contacts have no residual.
[[nodiscard]] bool has_contact_problems(const SceneResult& scene);

/// Runs of one scene with different numbers.
struct [[nodiscard]] SceneSweepResult {
  SceneRequest request;
  Outcome outcome;  // stalled: at least one run is
  std::string name;
  std::vector<SceneResult> runs;  // completed runs; the last number varies fastest
  FileDigests files;
};

/// Returns true if a name or file is a scene, rather than a subject.
[[nodiscard]] bool is_scene(const std::string& name_or_path, const std::string& data);

/// Scene built from its file and the robots that it names.
struct OpenScene {
  BuiltScene built;
  std::vector<SourceText> sources;
  FileDigests files;
};
/// Builds a scene. @param data  folder with robots/ ..; empty: the usual ones
/// @param path  tendon paths of human hands that state none; absent: default_path()
/// @throws DataError at the line of an error, InputError if a hand is not found.
[[nodiscard]] OpenScene open_scene(const SceneSpec& scene, const std::string& data = "",
                                   const std::optional<Path>& path = {});

/// Scene with the options of a request.
struct RequestedScene {
  SceneSpec spec;
  OpenScene open;
  SceneRequest request;
};
/// Reads and builds the requested scene, with the method, pads and times of the request.
/// @throws as open_scene(), or InputError for an unknown name in the request.
[[nodiscard]] RequestedScene open_requested_scene(const SceneRequest& request);
[[nodiscard]] RequestedScene open_requested_scene(SceneSpec scene, const SceneRequest& request);

/// Returns the data from which the hands of a scene are built, in the order of the scene.
/// @param data, path  see open_scene()
/// @param files  receives the digests of their files
/// @throws as open_scene()
[[nodiscard]] std::vector<SceneHand> hands_of_scene(const SceneSpec& scene, const std::string& data,
                                                    FileDigests& files,
                                                    const std::optional<Path>& path = {});

/// Simulates one run of a scene; `request.vary` must be empty.
/// @throws InputError or DataError saying what is unknown or wrong.
[[nodiscard]] SceneResult simulate_scene(const SceneRequest& request,
                                         const Progress& progress = {});

/// Simulates one run of a scene that a program has built, see SceneBuilder.
/// @param request  options; its `scene` is ignored
/// @throws InputError or DataError, with the scene's name instead of a file.
[[nodiscard]] SceneResult simulate_scene(const SceneSpec& scene, const SceneRequest& request = {},
                                         const Progress& progress = {});

/// Simulates a run for each combination of the numbers that vary, several in parallel; each run is
/// bitwise equal to a single one. If stopped, keeps started runs up to that instant.
///
/// Under mpirun the processes share the runs, each with its threads. Only the first process gets
/// the result, which is the same as without mpirun; the others get no value. Call it once in a
/// program.
/// @throws as simulate_scene(), or for more than kMaxRuns runs; where several processes fail, the
///         first throws.
[[nodiscard]] std::optional<SceneSweepResult> sweep_scene(const SceneRequest& request,
                                                          const Progress& progress = {});
inline constexpr std::size_t kMaxRuns = 10000;  // largest number of runs of a sweep [1]

/// Format name in files of scene runs.
inline constexpr const char* kSceneRunFormat = "thenar scene run 1";

/// Writes all instants as HDF5, dimensions labelled as xarray expects, with the texts and hashes of
/// all sources and the record of the run; of a sweep a summary of all runs, and each in a group.
/// @throws InputError if the file cannot be written, or the scene has no file, which readers of a
///         run need.
void write_scene_run(const SceneResult& scene, const std::string& path, const RunRecord& run = {});
void write_scene_sweep(const SceneSweepResult& sweep, const std::string& path,
                       const RunRecord& run = {});

}  // namespace thenar
