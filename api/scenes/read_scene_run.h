#pragma once

/// Reader of recorded runs of scenes.
///
///     const RecordedScene run = read_scene_run("run.h5");

#include <optional>
#include <string>
#include <vector>

#include "api/scenes/simulate_scene.h"
#include "dynamics/stepping/limit_excess.h"

namespace thenar {

/// Run written by write_scene_run(), with its rebuilt scene.
struct RecordedScene {
  std::string name;          // name of the scene
  BuiltScene built;          // scene built from the texts in the file and the files that they name
  std::optional<Path> path;  // SceneRequest::path of the run; via points in files of before 0.2
  std::optional<Camera> camera;      // absent: the scene states none
  std::vector<SceneSample> samples;  // at least one, by rising time; without z and w
  std::vector<std::string> muscles;  // "human:skewed/index/FDP2"
  Eigen::MatrixXd tension;           // tensions of the muscles [N] (instants, muscles)
  long steps = 0, unsolved = 0;      // see SceneCost
  double worst_residual = 0;         // see SceneCost [1]
  double deepest = 0;                // see SceneCost [m]
  std::optional<FlowBalance>
      balance;  // worst_balance(), its error and exchanged energy only; absent: not recorded
  std::vector<PassedLimit> limits;    // limits that joints exceeded
  std::vector<std::string> warnings;  // doubts about the record
};

/// Reads a run. Hands and meshes are searched for in the original folder of the scene and in the
/// data that come with thenar. They are verified by the places of all bodies at the first and the
/// last instant.
/// @param data  folder with robots/ ..; empty: the usual ones
/// @throws DataError or InputError if the file is no run of a scene or a sweep of several, if its
/// parts are inconsistent or numbers are not finite, or if input files have changed since.
[[nodiscard]] RecordedScene read_scene_run(const std::string& path, const std::string& data = "");

}  // namespace thenar
