#pragma once

/// Sources of live motions: scenes of files, and worlds in their present state.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/scenes/simulate_scene.h"
#include "api/scenes/world_scene.h"

namespace thenar {

/// Scene that a live motion moves.
struct MotionSource {
  std::string name;                         // of the scene or world
  std::shared_ptr<const BuiltScene> built;  // never null
  std::optional<Camera> camera;
  std::vector<std::string> warnings;  // what was assumed
  std::optional<double> duration;     // of the scene; none: it has no end [s]
};

/// A scene of a file. Whatever its method, it is stepped by a fixed length: that of the request, of
/// the file, or 1 ms.
/// @throws as open_requested_scene()
[[nodiscard]] MotionSource scene_motion(const SceneRequest& request);

/// A world as it stands: build_world_scene(). @param step  [s]; absent: 1 ms
/// @throws as build_world_scene()
[[nodiscard]] MotionSource world_motion(const WorldSpec& world, const std::string& data,
                                        WorldDrives drives, std::optional<double> step = {});

}  // namespace thenar
