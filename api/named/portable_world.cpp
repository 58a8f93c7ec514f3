#include "api/named/portable_world.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>

#include "api/named/shipped_data.h"
#include "api/named/worlds.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "data/io/file_kind.h"
#include "data/io/robot/import_robot.h"
#include "data/io/world/named_parts.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

using FileSet = std::set<fs::path>;

constexpr std::size_t kMaxCopied = 1UL << 30U;  // largest file that goes with a world [bytes]

fs::path whole_path(const fs::path& folder, const fs::path& file) {
  return fs::absolute(folder / file).lexically_normal();
}

/// Returns true if two files have the same bytes; false also if one of them cannot be read.
bool same_bytes(const fs::path& a, const fs::path& b) {
  std::error_code failed;
  if (!fs::is_regular_file(b, failed)) return false;
  std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
  using Bytes = std::istreambuf_iterator<char>;
  return first && second && std::equal(Bytes(first), Bytes(), Bytes(second), Bytes());
}

/// The files below a folder, as seen from it; none where it cannot be read.
FileSet files_below(const fs::path& folder) {
  FileSet files;
  std::error_code failed;
  fs::recursive_directory_iterator next(folder, failed), end;
  for (; !failed && next != end; next.increment(failed))
    if (!next->is_directory(failed)) files.insert(next->path().lexically_relative(folder));
  return files;
}

/// Returns true if a path leads neither up nor to the root.
bool stays_below(const fs::path& path) {
  return path.is_relative() && (path.empty() || *path.begin() != "..");
}

/// The folder that holds all files, the deepest.
fs::path common_folder(const FileSet& files) {
  fs::path common = files.begin()->parent_path();
  const auto holds = [&](const fs::path& file) {
    return stays_below(file.lexically_relative(common));
  };
  while (!all_of(files, holds)) common = common.parent_path();
  return common;
}

/// Returns the files that were read and those that their formats read beside them, by absolute
/// paths.
FileSet with_files_beside(const FileDigests& read) {
  FileSet all;
  for (const auto& [file, digest] : read) {
    const fs::path whole = whole_path("", file);
    all.insert(whole);
    // Add the buffer files of a glTF.
    std::error_code failed;
    if (whole.extension() == ".gltf")
      for (const fs::directory_entry& other : fs::directory_iterator(whole.parent_path(), failed))
        if (other.path().extension() == ".bin") all.insert(other.path());
  }
  return all;
}

/// Returns all files that are read to build the hand of a file.
FileDigests files_of_hand(const std::string& file) {
  const bool is_subject =
      fs::path(file).extension() == ".toml" && find_file_kind(file) == FileKind::kSubject;
  return is_subject ? digests_of({file}) : import_robot(file).files;
}

/// Gathers what goes with a world.
class Gathering {
 public:
  Gathering(const std::string& path, const std::vector<std::string>& wholes)
      : beside_(fs::absolute("." / fs::path(path).parent_path()).lexically_normal()),
        folder_(beside_ / (fs::path(path).stem().string() + "_files")) {
    for (const std::string& whole : wholes) wholes_.push_back(whole_path("", whole));
  }

  /// The file as the world is to name it, now that it goes with it if it has to.
  /// @param file  as seen from the world's folder;  @param read  all that is read with it
  std::string placed(const std::string& file, const std::function<FileDigests()>& read) {
    // Files below the folder of the world travel with it as they are.
    if (file.empty() || stays_below(fs::path(file).lexically_normal())) return file;
    const fs::path whole = whole_path(beside_, file);
    FileCopies copies = files_with(whole, read);
    // Bodies that share a file share the copy.
    const auto same = std::find_if(copies_.begin(), copies_.end(), [&](const FileCopies& other) {
      return other.from == copies.from && other.files == copies.files;
    });
    if (same != copies_.end()) {
      copies.to = same->to;
    } else {
      copies.to = free_place(copies);
      copies_.push_back(copies);
    }
    // The new name leads from the world's folder to the copy.
    return (copies.to / whole.lexically_relative(copies.from)).lexically_relative(beside_);
  }

  [[nodiscard]] std::vector<FileCopies> copies() && { return std::move(copies_); }

 private:
  [[nodiscard]] FileCopies files_with(const fs::path& file,
                                      const std::function<FileDigests()>& read) const {
    for (const fs::path& whole : wholes_)
      if (stays_below(file.lexically_relative(whole))) return {whole, {}, files_below(whole)};
    FileSet files = with_files_beside(read());
    files.insert(file);
    FileCopies copies{common_folder(files), {}, {}};
    for (const fs::path& each : files) copies.files.insert(each.lexically_relative(copies.from));
    return copies;
  }

  [[nodiscard]] fs::path free_place(const FileCopies& copies) const {
    for (int number = 1;; ++number) {
      fs::path to = folder_ / std::to_string(number);
      const bool taken = any_of(copies_, [&](const FileCopies& other) { return other.to == to; });
      if (!taken && (!fs::exists(fs::symlink_status(to)) || is_there(copies, to))) return to;
    }
  }

  /// Returns true if a folder holds exactly the same files.
  static bool is_there(const FileCopies& copies, const fs::path& folder) {
    return copies.files == files_below(folder) && all_of(copies.files, [&](const fs::path& file) {
             return same_bytes(copies.from / file, folder / file);
           });
  }

  fs::path beside_, folder_;  // of the world's file, of what goes with it
  std::vector<fs::path> wholes_;
  std::vector<FileCopies> copies_;
};

}  // namespace

WorldSpec read_world_at(const std::string& path, const std::string& data) {
  return read_world(path, data_for(fs::path(path).parent_path().string(), data));
}

SceneSpec read_scene_at(const std::string& path, const std::string& data) {
  return read_scene(path, data_for(fs::path(path).parent_path().string(), data));
}

std::string shipped_name(const std::string& file, const std::string& folder,
                         const FileDigests& files) {
  const fs::path given(file);
  std::string name = given.stem().string();
  // Names of data have no dots and end in .toml; others cannot be found by name again.
  if (given.extension() != ".toml" || name.find('.') != std::string::npos) return "";
  for (const std::string& place : shipped_data()) {
    const fs::path here = fs::path(place) / folder;
    std::error_code failed;
    // The same file, reached by another path, needs no comparison of bytes.
    if (fs::equivalent(given, here / given.filename(), failed)) return name;
    // A copy counts as shipped only if all files that it reads are the same, byte by byte.
    const bool same = all_of(files, [&](const auto& read) {
      const fs::path seen =
          whole_path("", read.first).lexically_relative(whole_path("", given).parent_path());
      return same_bytes(read.first, here / seen);
    });
    if (same && same_bytes(given, here / given.filename())) return name;
  }
  return "";
}

WorldSpec with_shipped_names(const WorldSpec& world, const std::string& folder) {
  WorldSpec named = seen_from_folder(world, folder);
  // Hands may be robots or subjects.
  for (PlacedHand& hand : named.hands) {
    if (hand.file.empty()) continue;
    const std::string file = (fs::path(folder) / hand.file).lexically_normal().string();
    for (const char* kind : {"robots", "subjects"})
      if (const std::string name = shipped_name(file, kind, {{file, ""}}); !name.empty())
        hand.file = name;
  }
  // Bodies whose meshes are all those of a shipped object are named after it.
  for (PlacedBody& body : named.bodies) {
    if (body.file.empty()) continue;
    const std::string file = (fs::path(folder) / body.file).lexically_normal().string();
    if (const std::string name = shipped_name(file, "objects", body.body.files); !name.empty())
      body.file = name;
  }
  return named;
}

PortableWorld portable_world(const WorldSpec& world, const std::string& path,
                             const std::vector<std::string>& wholes) {
  const fs::path folder = "." / fs::path(path).parent_path();
  // Name shipped data first: what comes with thenar needs no copies.
  PortableWorld portable{with_shipped_names(world, folder.string()), {}};
  Gathering gathering(path, wholes);
  const auto seen = [&](const std::string& file) {
    return (folder / file).lexically_normal().string();
  };
  // Copy all other files next to the world, bodies with the meshes that they read.
  for (PlacedHand& hand : portable.world.hands)
    hand.file = gathering.placed(hand.file, [&] { return files_of_hand(seen(hand.file)); });
  for (PlacedBody& body : portable.world.bodies) {
    const auto read = [&] { return body.body.files; };
    body.file = gathering.placed(body.file, read);
    if (!body.file.empty()) continue;
    for (ShapeSpec& shape : body.body.shapes)
      shape.mesh_file = gathering.placed(shape.mesh_file, read);
  }
  portable.world.materials_file = gathering.placed(portable.world.materials_file,
                                                   [&] { return portable.world.materials.files; });
  portable.copies = std::move(gathering).copies();
  return portable;
}

void write_copies(const PortableWorld& portable, const InsideFolder& folder) {
  for (const FileCopies& copies : portable.copies) {
    const fs::path name = copies.to.lexically_relative(folder.path());
    // The same files, there from before.
    if (folder.entry(name.string()) != InsideFolder::Entry::kNothing) continue;
    try {
      for (const fs::path& file : copies.files)
        folder.write((name / file).string(), read_file((copies.from / file).string(), kMaxCopied));
      // Remove an incomplete folder, as it would be taken for a complete one next time.
    } catch (const Error&) {
      std::error_code ignored;
      fs::remove_all(copies.to, ignored);
      throw;
    }
  }
}

void save_world(WorldSpec world, const std::string& path) {
  // Links in the folder's own path are the caller's.
  const fs::path parent = fs::absolute(path).parent_path();
  std::error_code failed;
  fs::create_directories(parent, failed);
  const InsideFolder folder(parent.string());
  const std::string target = (fs::path(folder.path()) / fs::path(path).filename()).string();
  const PortableWorld portable = portable_world(world, target);
  write_copies(portable, folder);
  write_file(path, world_toml(portable.world));
}

}  // namespace thenar
