#pragma once

/// Files of hands that were dropped into a world: where they stand in the session's own folder, and
/// where they go when the world is saved.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "api/live/world/live_world.h"
#include "base/inside_folder.h"

namespace thenar {

/// The file of a hand that was dropped into the world, as seen from the world's own folder:
/// "1/hand/robot.urdf"; "" of others.
[[nodiscard]] std::string imported_file(const LiveWorld& live, const PlacedHand& hand);

/// A file as worlds in a folder name it. @param file  relative to where the program runs
[[nodiscard]] std::string file_seen_from(const std::string& folder, const std::string& file);

/// A world to be saved, and the folders of imported files that are to go with it.
struct SavedWorld {
  WorldSpec world;
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> copies;  ///< from, to
};

/// The world with imported files named as they will stand in `folder`: of OWN/3/robot.urdf all of
/// OWN/3 goes to FOLDER/3, or to the next number that is free. A number is free if nothing has it,
/// or if the very same files are there already.
[[nodiscard]] SavedWorld with_files_in(const LiveWorld& live, const std::filesystem::path& folder);

/// Copies the files. What was there before stays as it is; of a copy that fails nothing stays.
/// @param folder  that the world is saved in, or below
/// @throws InputError if they cannot be written
void write_copies(const SavedWorld& saved, const InsideFolder& folder);

}  // namespace thenar
