#pragma once

/// Files of hands that were dropped into a world, in the session's own folder.

#include <string>
#include <vector>

#include "live/world/live_world.h"

namespace thenar {

/// The file of a hand that was dropped into the world, as seen from the world's own folder:
/// "1/hand/robot.urdf"; "" of others.
[[nodiscard]] std::string imported_file(const LiveWorld& live, const PlacedHand& hand);

/// The folders of dropped hands of the world, OWN/1, OWN/3: each goes as a whole where the world is
/// saved.
[[nodiscard]] std::vector<std::string> imported_folders(const LiveWorld& live);

/// A file as worlds in a folder name it. @param file  relative to where the program runs
[[nodiscard]] std::string file_seen_from(const std::string& folder, const std::string& file);

}  // namespace thenar
