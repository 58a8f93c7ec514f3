#pragma once

/// Worlds that can be moved and sent: files that come with thenar are referred to by name, all
/// others are copied along.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/inside_folder.h"
#include "data/io/scene/scene.h"
#include "data/io/world/world.h"

namespace thenar {

/// Files copied with a world from below `from` to the same relative paths below `to`.
struct FileCopies {
  std::filesystem::path from, to;         // folders
  std::set<std::filesystem::path> files;  // files to copy, relative to either folder
};

/// World to be saved, and the files to be copied with it.
struct PortableWorld {
  WorldSpec world;                 // world with relative paths and names
  std::vector<FileCopies> copies;  // files that the world needs
};

/// Reads a world, whose hands and objects may be given by name.
/// @param data  folder with robots/, objects/ ..; empty: the usual ones, and those near the world
[[nodiscard]] WorldSpec read_world_at(const std::string& path, const std::string& data);
/// Reads a scene in the same way.
[[nodiscard]] SceneSpec read_scene_at(const std::string& path, const std::string& data);

/// Returns the name by which every installation finds a file: "mug" of
/// THENAR/data/objects/mug.toml; "" for a file that does not come with thenar.
/// @param folder  "objects"
/// @param files  digests of all files read with it, itself included: they must exist with equal
///         content
[[nodiscard]] std::string shipped_name(const std::string& file, const std::string& folder,
                                       const FileDigests& files);

/// Returns the world with paths relative to a folder, and names for files that come with thenar.
[[nodiscard]] WorldSpec with_shipped_names(const WorldSpec& world, const std::string& folder);

/// Returns the world to be saved and the files to be copied. Files that come with thenar are
/// referred to by name. Files in the folder of `path` or below keep their places. All others are
/// copied to folders "NAME_files/1", "NAME_files/2" .. beside it; numbers are skipped whose folders
/// exist with other files.
/// @param path    file in which it will be saved
/// @param wholes  folders that are copied whole if one of their files is
/// @throws InputError or DataError if a robot to be copied cannot be read any more.
[[nodiscard]] PortableWorld portable_world(const WorldSpec& world, const std::string& path,
                                           const std::vector<std::string>& wholes = {});

/// Writes the copies without following links. Existing files are kept; a copy that fails is
/// removed.
/// @param folder  folder of the saved world, or a parent of it
/// @throws InputError if they cannot be written.
void write_copies(const PortableWorld& portable, const InsideFolder& folder);

}  // namespace thenar
