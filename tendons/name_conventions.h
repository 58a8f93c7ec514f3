#pragma once

/// Kinds of joints and muscles by their names: "MCP2_AA" abducts, "RU_PS" pronates, "FDP2" flexes.

#include <string>

namespace thenar {

[[nodiscard]] inline bool ends_with(const std::string& name, const std::string& ending) {
  return name.size() >= ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

/// Whether a joint's axis is one of flexion: it neither abducts nor pronates.
[[nodiscard]] inline bool is_flexion_joint(const std::string& joint) {
  return !ends_with(joint, "_AA") && !ends_with(joint, "_PS");
}

/// FDS, FDP or FPL of any digit: muscles that run in a sheath along the flexor side of every joint.
[[nodiscard]] inline bool is_long_flexor(const std::string& muscle) {
  return muscle.rfind("FDS", 0) == 0 || muscle.rfind("FDP", 0) == 0 || muscle.rfind("FPL", 0) == 0;
}

}  // namespace thenar
