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

/// A number of a scene that differs from run to run; names and units as set_number().
struct SceneVariation {
  std::string name;
  double from = 0, to = 0;
  int count = 1;  // values, evenly spaced, both ends among them

  [[nodiscard]] double value(int i) const {
    return count == 1 ? from : from + (to - from) * i / (count - 1);
  }
};

/// Options of a scene's simulation; absent values are those of the scene's file.
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

/// A scene that was simulated.
struct [[nodiscard]] SceneResult {
  SceneRequest request;
  Outcome outcome;  // stalled: not to be used, see run.status
  std::string name, description;
  std::optional<Camera> camera;
  std::shared_ptr<const BuiltScene> built;  // simulated scene with its assumptions; never null
  std::vector<std::pair<std::string, double>> varied;  // numbers that are not as in the file
  SceneRun run;
  RunMeasures measures;
  std::vector<SourceText> sources;  // scene, hands, objects, materials; meshes are in `files` only
  FileDigests files;                // digests of all files that were read
};

/// Returns true if the scene's method solves contact problems; contacts as springs have no
/// residual.
[[nodiscard]] bool has_contact_problems(const SceneResult& scene);

/// Runs of one scene.
struct [[nodiscard]] SceneSweepResult {
  SceneRequest request;
  Outcome outcome;  // stalled: a run is
  std::string name;
  std::vector<SceneResult> runs;  // the last number varies fastest; those that ran
  FileDigests files;
};

/// Returns true if a name or file is a scene, rather than a subject.
[[nodiscard]] bool is_scene(const std::string& name_or_path, const std::string& data);

/// A scene built from its file and the robots that it names.
struct OpenScene {
  BuiltScene built;
  std::vector<SourceText> sources;
  FileDigests files;
};
/// @param data  folder with robots/ ..; empty: the usual ones
/// @param path  of tendons of human hands that state none; absent: default_path()
/// @throws DataError at the line of what does not fit, InputError if a hand is not to be found.
[[nodiscard]] OpenScene open_scene(const SceneSpec& scene, const std::string& data = "",
                                   const std::optional<Path>& path = {});

/// A scene as its file and a request have it.
struct RequestedScene {
  SceneSpec spec;
  OpenScene open;
  SceneRequest request;
};
/// Reads and opens the scene that is asked for, with the method, pads and times of the request.
/// @throws as open_scene(), or InputError where the request names what is not there.
[[nodiscard]] RequestedScene open_requested_scene(const SceneRequest& request);
[[nodiscard]] RequestedScene open_requested_scene(SceneSpec scene, const SceneRequest& request);

/// Returns the data from which the hands of a scene are built, in the order of the scene.
/// @param data, path  as of open_scene()
/// @param files  receives the files that were read for them
/// @throws as open_scene()
[[nodiscard]] std::vector<SceneHand> hands_of_scene(const SceneSpec& scene, const std::string& data,
                                                    FileDigests& files,
                                                    const std::optional<Path>& path = {});

/// Simulates one run of a scene; `request.vary` must be empty.
/// @throws InputError or DataError saying what is unknown or wrong.
[[nodiscard]] SceneResult simulate_scene(const SceneRequest& request,
                                         const Progress& progress = {});

/// Simulates one run of a scene that a program has built, see SceneBuilder.
/// @param request  whose `scene` is not used
/// @throws InputError or DataError, in which the scene's name stands for its file.
[[nodiscard]] SceneResult simulate_scene(const SceneSpec& scene, const SceneRequest& request = {},
                                         const Progress& progress = {});

/// Simulates a run for each combination of the numbers that vary, several at once; each run is the
/// same to the bit as by itself. Stopped: runs that have begun are kept up to there.
///
/// Started by mpirun, all processes simulate together, each with its threads, and only the first
/// has the answer, the same as without: the others have nothing. Call it once in a program.
/// @throws as simulate_scene(), or if there would be more than kMostRuns; where several processes
/// fail, the first throws.
[[nodiscard]] std::optional<SceneSweepResult> sweep_scene(const SceneRequest& request,
                                                          const Progress& progress = {});
inline constexpr std::size_t kMostRuns = 10000;

/// Format name in files of scene runs.
inline constexpr const char* kSceneRunFormat = "thenar scene run 1";

/// Writes all instants as HDF5, dimensions labelled as xarray expects, with the texts and hashes of
/// all sources and the record of the run; of a sweep a summary of all runs, and each in a group.
/// @throws InputError if the file cannot be written, or the scene has no file: a run is read with
/// it.
void write_scene_run(const SceneResult& scene, const std::string& path, const RunRecord& run = {});
void write_scene_sweep(const SceneSweepResult& sweep, const std::string& path,
                       const RunRecord& run = {});

}  // namespace thenar
