#pragma once

/// Worlds that can be moved and sent: what comes with thenar is told by its name, all else goes
/// with them.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/inside_folder.h"
#include "data/io/world/world.h"

namespace thenar {

/// Files that go with a world, each to the same place below `to` as it has below `from`.
struct FileCopies {
  std::filesystem::path from, to;         // folders
  std::set<std::filesystem::path> files;  // as seen from either of them
};

/// A world to be saved, and the files that are to go with it.
struct PortableWorld {
  WorldSpec world;
  std::vector<FileCopies> copies;
};

/// Reads a world, whose hands and objects may be told by name.
/// @param data  folder with robots/, objects/ ..; empty: the usual ones, and those near the world
[[nodiscard]] WorldSpec read_world_at(const std::string& path, const std::string& data);

/// Returns the name by which a file is found wherever thenar is: "mug" of
/// THENAR/data/objects/mug.toml; "" of one that does not come with thenar.
/// @param folder  "objects"
/// @param files   that are read with it, itself among them: they must be there and the same, too
[[nodiscard]] std::string shipped_name(const std::string& file, const std::string& folder,
                                       const FileDigests& files);

/// Returns the world as seen from a folder, with what comes with thenar told by its name.
[[nodiscard]] WorldSpec with_shipped_names(const WorldSpec& world, const std::string& folder);

/// Returns the world as it can be saved. What comes with thenar is told by its name. What stands
/// beside the file or below stays where it is. All else goes into folders "NAME_files/1",
/// "NAME_files/2" .. beside it, of which those are free that nothing has, or that hold the very
/// same files already.
/// @param path    of the file that it will be saved in
/// @param wholes  folders that are taken as a whole if one of their files is
/// @throws InputError or DataError if a robot that is to go with it cannot be read any more.
[[nodiscard]] PortableWorld portable_world(const WorldSpec& world, const std::string& path,
                                           const std::vector<std::string>& wholes = {});

/// Writes the copies without following links. What was there before stays as it is; of a copy that
/// fails nothing stays.
/// @param folder  that the world is saved in, or below
/// @throws InputError if they cannot be written.
void write_copies(const PortableWorld& portable, const InsideFolder& folder);

}  // namespace thenar
