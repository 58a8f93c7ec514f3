#pragma once

/// Bushings between bodies of a scene, as plain data.

#include <array>
#include <limits>
#include <string>

#include <Eigen/Core>

#include "data/io/toml_table.h"

namespace thenar {

/// Six springs between two bodies, at rest at the start. They close loops, which trees have not.
struct SceneBushingSpec {
  std::string name;
  std::string from, to;               // body, or "HAND/LINK"; empty `from`: the world
  Eigen::Vector3d point{0, 0, 0};     // initial position, world [m] (3)
  Eigen::Vector3d axis{0, 0, 1};      // initial axis of flexion, unit, world (3)
  std::array<double, 6> stiffness{};  // stiffness at rest: across, along, axial [N/m]; flexion,
                                      // abduction, twist [N m/rad]
  std::array<double, 6> damping{};    // [N s/m], [N m s/rad]
  double translation_toe = std::numeric_limits<double>::infinity();  // [m]
  double rotation_toe = std::numeric_limits<double>::infinity();     // [rad]
  double stiffening = 20;  // largest stiffness over that at rest [1]
  int line = 1;            // line in the file
};

namespace internal {

/// Reads [[bushing]].
[[nodiscard]] SceneBushingSpec read_scene_bushing(TomlTable& table);

}  // namespace internal
}  // namespace thenar
