#pragma once

/// Sources of live motions: scenes from files, and worlds in their current state.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/scenes/simulate_scene.h"
#include "api/scenes/world_scene.h"

namespace thenar {

/// Scene that a live motion moves.
struct MotionSource {
  std::string name;                         // name of the scene or world
  std::shared_ptr<const BuiltScene> built;  // never null
  std::optional<Camera> camera;
  std::vector<std::string> warnings;  // assumptions of the scene
  std::optional<double> duration;     // duration of the scene; absent: no end [s]
};

/// Opens a scene from a file. It is always simulated by time stepping with a fixed step size: that
/// of the request, else that of the file, else 1 ms.
/// @throws as open_requested_scene()
[[nodiscard]] MotionSource scene_motion(const SceneRequest& request);

/// Builds a scene from a world in its current state, by build_world_scene().
/// @param data  folder with robots/, objects/ ..  @param step  step size; absent: 1 ms [s]
/// @throws as build_world_scene()
[[nodiscard]] MotionSource world_motion(const WorldSpec& world, const std::string& data,
                                        WorldDrives drives, std::optional<double> step = {});

}  // namespace thenar
