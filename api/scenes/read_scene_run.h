#pragma once

/// Runs of scenes from their files, to be looked at again.

#include <optional>
#include <string>
#include <vector>

#include "api/scenes/simulate_scene.h"
#include "dynamics/stepping/limit_excess.h"

namespace thenar {

/// A run as write_scene_run() wrote it, with its scene built again.
struct RecordedScene {
  std::string name;  // name of the scene
  BuiltScene built;  // scene built from the texts that the file keeps and the files that they name
  std::optional<Path> path;  // SceneRequest::path of the run; via points in files of before 0.2
  std::optional<Camera> camera;
  std::vector<SceneSample> samples;    // at least one, by rising time; without z and w
  std::vector<std::string> muscles;    // "human:skewed/index/FDP2"
  Eigen::MatrixXd tension;             // tensions of the muscles [N] (instants, muscles)
  long steps = 0, unsolved = 0;        // see SceneCost
  double worst_residual = 0;           // see SceneCost [1]
  double deepest = 0;                  // see SceneCost [m]
  std::optional<FlowBalance> balance;  // worst_balance(), of which its error and what was turned
                                       // over are kept; nothing: not recorded
  std::vector<PassedLimit> limits;     // limits that joints exceeded
  std::vector<std::string> warnings;
};

/// Reads a run. Hands and meshes are found beside the scene as it stood when the run was made, or
/// among what comes with thenar; that they are those of the run is held against the places of all
/// bodies at the first and the last instant.
/// @param data  folder with robots/ ..; empty: the usual ones
/// @throws DataError or InputError saying what is wrong: no run of a scene, a sweep of several,
/// what does not fit together, numbers that are not finite, or files that have changed since.
[[nodiscard]] RecordedScene read_scene_run(const std::string& path, const std::string& data = "");

}  // namespace thenar
