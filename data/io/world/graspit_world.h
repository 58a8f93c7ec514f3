#pragma once

/// Worlds of GraspIt!.

#include <string>
#include <vector>

#include "data/io/world/world.h"

namespace thenar {

/// A world that was imported, with elements that were not understood.
struct GraspitWorld {
  WorldSpec world;
  std::vector<std::string> warnings;  // "path:line: ..."
};

/// Reads a world in GraspIt! XML. Files that it names are searched beside it, then beside every
/// folder around it, because GraspIt! keeps worlds and models in different folders. Missing files,
/// and robots that cannot be read, are left out with a warning.
///   <graspableBody>, <obstacle>  bodies that move and that do not
///   <robot>       a hand or arm: its absolute file; its warnings; <dofValues> by graspit_posture()
///   <connection>  a robot on the end of another's chain: carrier_link as the robot's importer
///   names
///                 it, X_WH on that link [m]
///   <camera>      as SoCamera: looks along -z, towards the focal point
/// @throws DataError if it is no world, or a body cannot be read.
/// Source: [GraspItWorld] for the format.
[[nodiscard]] GraspitWorld read_graspit_world(const std::string& path);

}  // namespace thenar
