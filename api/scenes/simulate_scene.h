#pragma once

/// Simulation of a scene of bodies and hands.
/// Example: examples/12_falling_cube.cpp, examples/15_human_scene.cpp.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/scenes/open_scene.h"
#include "base/progress.h"
#include "dynamics/scene/measure_run.h"
#include "solvers/status.h"

namespace thenar {

/// Result of a simulated scene.
struct [[nodiscard]] SceneResult {
  SceneRequest request;                     // request that was answered
  Outcome outcome;                          // stalled: do not use it, see run.status
  std::string name, description;            // as in the scene's file
  std::optional<Camera> camera;             // absent: the scene states none
  std::shared_ptr<const BuiltScene> built;  // simulated scene with its assumptions; never null
  std::vector<std::pair<std::string, double>> varied;  // numbers that differ from the file
  SceneRun run;                                        // instants, cost and status
  RunMeasures measures;                                // poses, energy, slip and pulls
  std::vector<SourceText> sources;  // scene, hands, objects, materials; meshes are in `files` only
  FileDigests files;                // digests of all files that were read
};

/// Returns true if the scene's method solves contact problems; compliant contacts have no residual.
[[nodiscard]] bool has_contact_problems(const SceneResult& scene);

/// Runs of one scene with different numbers.
struct [[nodiscard]] SceneSweepResult {
  SceneRequest request;           // request that was answered
  Outcome outcome;                // stalled: at least one run is
  std::string name;               // name of the scene
  std::vector<SceneResult> runs;  // completed runs; the last number varies fastest
  FileDigests files;              // digests of all files that were read
};

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

}  // namespace thenar
