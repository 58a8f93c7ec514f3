#pragma once

/// Live worlds from and to files.

#include <string>
#include <vector>

#include "base/progress.h"
#include "live/world/live_world.h"

namespace thenar {

/// Begins an empty world. It is an edit: undo() brings the world before back.
void new_world(LiveWorld& live);

/// Loads a world by its name, or from a file.
/// @return what was assumed: materials of bodies, what is missing of robots
/// @throws InputError, DataError where it is not to be found or wrong, and the world stays as it
/// was
std::vector<std::string> load_world(LiveWorld& live, const std::string& world,
                                    const Progress& progress = {});

/// Loads a world from the text of its file, whose files are relative to the working folder.
/// @param name  for messages, and that it is saved by: "my_world"
/// @return, @throws  as load_world()
std::vector<std::string> load_world_text(LiveWorld& live, const std::string& text,
                                         const std::string& name, const Progress& progress = {});

/// The world as the text of a file in the working folder.
/// @throws InputError if files of a hand were imported: a text does not hold them, and they go with
///         the session
[[nodiscard]] std::string world_text(const LiveWorld& live);

/// Files that saving may replace, besides the file of the world itself.
enum class SaveOver { kNothing, kAnything };

/// Saves the world so that it can be moved, as portable_world(): things that come with thenar by
/// their names, files of hands and objects from elsewhere in a folder "NAME_files" beside it. Files
/// that were there before stay, whatever `over` says.
/// @param file  a name in the working folder as OutsideUse::kInside, ".toml"
/// @param over  kNothing: a file that the world was neither loaded from nor saved to stays
/// @return the path that was written
/// @throws InputError if it is elsewhere or behind a link, would replace what `over` lets stay, or
///         cannot be written
std::string save_live_world(LiveWorld& live, const std::string& file,
                            SaveOver over = SaveOver::kNothing);

/// The state of a world that was read: its hands built, or taken where they were built before.
/// @param path  for messages
[[nodiscard]] WorldState state_of_world(LiveWorld& live, const WorldSpec& world,
                                        const std::string& path, const Progress& progress = {});

}  // namespace thenar
