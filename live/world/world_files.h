#pragma once

/// Loading and saving of live worlds.

#include <string>
#include <vector>

#include "base/progress.h"
#include "live/world/live_world.h"

namespace thenar {

/// Replaces the world by an empty one; undo() restores it.
void new_world(LiveWorld& live);

/// Loads a world by name or from a file. If this throws, the current world is unchanged.
/// @return assumptions: materials of bodies, missing parts of robots
/// @throws InputError, DataError if it is not found or invalid
std::vector<std::string> load_world(LiveWorld& live, const std::string& world,
                                    const Progress& progress = {});

/// Loads a world from the text of its file; paths in it are relative to the working folder.
/// @param name  name for messages, "my_world"
/// @return, @throws  as load_world()
std::vector<std::string> load_world_text(LiveWorld& live, const std::string& text,
                                         const std::string& name, const Progress& progress = {});

/// Returns the world as the text of a file in the working folder.
/// @throws InputError if a hand was imported: the text cannot hold its files, which are removed
///         with the session
[[nodiscard]] std::string world_text(const LiveWorld& live);

/// Files that saving may overwrite, besides the world's own file.
enum class Overwrite { kNothing, kAnything };

/// Saves the world as a portable_world(): things that are shipped with thenar by name, copies of
/// the files of other hands and objects in a folder "NAME_files" beside it. Existing files in that
/// folder are never overwritten.
/// @param file  path in the working folder as for OutsideUse::kInside, ending in ".toml"
/// @param over  kNothing: only the file that the world was loaded from or saved to is overwritten
/// @return path of the file
/// @throws InputError if the file is outside the folder or behind a link, must not be overwritten,
///         or cannot be written
std::string save_live_world(LiveWorld& live, const std::string& file,
                            Overwrite over = Overwrite::kNothing);

/// Builds the state of a world; hands that were built before are reused.
/// @param path  file of the world, for messages
[[nodiscard]] WorldState state_of_world(LiveWorld& live, const WorldSpec& world,
                                        const std::string& path, const Progress& progress = {});

}  // namespace thenar
