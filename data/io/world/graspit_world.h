#pragma once

/// Worlds of GraspIt!.

#include <string>
#include <vector>

#include "data/io/world/world.h"

namespace thenar {

/// What an importer read, and what it did not understand.
struct GraspitWorld {
  WorldSpec world;
  std::vector<std::string> warnings;  // "path:line: ..."
};

/// Reads a world in GraspIt! XML. Files that it names are looked for beside it, then beside every
/// folder around it, as worlds and models lie in different folders there; those that are missing,
/// and robots that cannot be read, are left out with a warning.
///   <graspableBody>, <obstacle>  bodies that move and that do not, written out
///   <robot>       a hand or arm: its file, absolute; its warnings; <dofValues> as
///                 graspit_posture() reads them
///   <connection>  a robot on the end of another's chain: carrier_link as the robot's importer
///                 calls it, X_WH on that link
///   <camera>      as SoCamera: looks along -z, towards the focal point
/// @throws DataError if it is no world, or a body cannot be read.
/// Source: [GraspItWorld] for the format.
[[nodiscard]] GraspitWorld read_graspit_world(const std::string& path);

}  // namespace thenar
