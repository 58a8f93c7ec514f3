#pragma once

/// Keys that worlds and moving scenes have in common.

#include <map>
#include <string>
#include <vector>

#include "data/io/toml_table.h"
#include "data/io/world/world.h"

namespace thenar::internal {

/// Returns the path of a file that a key names, relative to the working directory.
/// @param folder  that the key is relative to
[[nodiscard]] std::string file_beside(TomlTable& table, const std::string& key,
                                      const std::string& folder);

/// Returns the path of a file that a key names, as seen from a folder: as it is written, or, of
/// "mug" without a folder and an ending, of PLACE/objects/mug.toml, unless there is a file "mug" in
/// the folder.
/// @param kinds   folders of places: {"robots", "subjects"}
/// @param places  in the order of search; empty: files alone
[[nodiscard]] std::string file_or_name(TomlTable& table, const std::string& key,
                                       const std::string& folder,
                                       const std::vector<std::string>& kinds,
                                       const std::vector<std::string>& places);

/// Reads joint angles, positions of sliding joints, or either in SI as the writer states it:
/// coordinate
/// -> [rad] or [m].
[[nodiscard]] std::map<std::string, double> read_posture(TomlTable& table);

/// Reads a body from its own keys or from the file that it names, whose name and material may be
/// replaced; and its pose.
/// @param path    of the file of the table;  @param materials  that it may be made of
/// @param places  as of file_or_name()
[[nodiscard]] PlacedBody read_placed_body(TomlTable& table, const std::string& path,
                                          const Materials& materials,
                                          const std::vector<std::string>& places = {});

/// Reads the materials of the file that `materials` names over the built-in table, or returns that
/// table alone.
[[nodiscard]] Materials read_materials_key(TomlTable& top, const std::string& folder);

/// Reads [camera]; the usual one if there is none.
[[nodiscard]] Camera read_camera(TomlTable& top);

}  // namespace thenar::internal
