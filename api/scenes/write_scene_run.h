#pragma once

/// Files of simulated scenes.
///
///     write_scene_run(simulate_scene(request), "run.h5");

#include <string>

#include "api/scenes/simulate_scene.h"
#include "base/run_record.h"

namespace thenar {

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
