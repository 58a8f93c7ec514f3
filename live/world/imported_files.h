#pragma once

/// Files of hands that were imported into a world, in the world's temporary folder.

#include <string>
#include <vector>

#include "live/world/live_world.h"

namespace thenar {

/// Returns the file of an imported hand relative to the world's temporary folder,
/// "1/hand/robot.urdf"; "" for other hands.
[[nodiscard]] std::string imported_hand_file(const LiveWorld& live, const PlacedHand& hand);

/// Returns the folders of the world's imported hands, "FOLDER/1", "FOLDER/3"; saving the world
/// copies each of them as a whole.
[[nodiscard]] std::vector<std::string> imported_folders(const LiveWorld& live);

/// Returns the path of a file relative to a folder. @param file  relative to the current directory
[[nodiscard]] std::string file_seen_from(const std::string& folder, const std::string& file);

}  // namespace thenar
