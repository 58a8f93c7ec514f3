#include "live/world/world_import.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "api/import.h"
#include "base/error.h"
#include "base/inside_folder.h"
#include "base/outside_path.h"
#include "base/progress_parts.h"
#include "data/io/mesh/mesh_file.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 1000;            // of one drop
constexpr std::size_t kLongestName = 300;           // of a dropped file [bytes]
constexpr std::uintmax_t kMostKept = 256UL << 20U;  // of all hands that a world keeps [bytes]

/// The path of a dropped file within its folder. @throws InputError if it leads out of it
fs::path checked_name(const std::string& name) {
  require(name.size() <= kLongestName, "wanted names of dropped files of at most {} bytes, got {}",
          kLongestName, name.size());
  return outside_path(name, OutsideUse::kInside);
}

/// Returns true if a file holds data of an operating system: ".DS_Store", "__MACOSX/._tip.stl".
bool is_hidden(const std::string& name) {
  const std::string last = name.substr(name.rfind('/') + 1);
  return last.size() > 1 && last.front() == '.' && last != "..";
}

/// Lower case, as endings are compared.
std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool describes_robot(const fs::path& path) {
  static const std::set<std::string> endings{".urdf", ".xml", ".mjcf", ".toml"};
  return endings.count(ending_of(path)) > 0;
}

bool describes_body(const fs::path& path) {
  return ending_of(path) == ".toml" || ending_of(path) == ".xml";
}

/// The file that is the thing, of those that were dropped together.
fs::path main_file(const std::vector<fs::path>& files, DroppedAs as) {
  // A description beats a mesh, since it refers to the meshes beside it.
  const auto first = [&](const auto& test) {
    return std::find_if(files.begin(), files.end(), test);
  };
  auto found = first(as == DroppedAs::kHand ? describes_robot : describes_body);
  if (found == files.end() && as != DroppedAs::kHand)
    found = first([](const fs::path& path) { return is_mesh_file(path.string()); });
  require(found != files.end(), "none of the {} files is {}", files.size(),
          as == DroppedAs::kHand
              ? "a robot: wanted .urdf, .xml, .mjcf or .toml"
              : "an object: wanted .toml, .xml or a mesh (.obj, .stl, .ply, .off, .glb, .dae ..)");
  return *found;
}

/// A folder that is removed unless it is kept.
class DropFolder {
 public:
  explicit DropFolder(const std::string& parent) {
    // The lowest number that is free: the same drops have the same names.
    for (int number = 1; path_.empty(); ++number)
      if (const fs::path next = fs::path(parent) / std::to_string(number); !fs::exists(next))
        path_ = next;
    std::error_code failed;
    fs::create_directory(path_, failed);
    require(!failed, "'{}' cannot be made: {}", path_.string(), failed.message());
  }
  ~DropFolder() {
    std::error_code ignored;  // the whole is removed at the end anyway
    if (!kept_) fs::remove_all(path_, ignored);
  }
  DropFolder(const DropFolder&) = delete;
  DropFolder& operator=(const DropFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }
  void keep() { kept_ = true; }

 private:
  fs::path path_;
  bool kept_ = false;
};

/// Bytes of all files in a folder and below it.
std::uintmax_t bytes_below(const fs::path& folder) {
  std::uintmax_t sum = 0;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none))
    if (entry.is_regular_file(none)) sum += entry.file_size(none);
  return sum;
}

/// Refuses files for which a world has no room beside the hands that it keeps for undone steps.
void require_room(const std::string& folder, const std::vector<DroppedFile>& files) {
  std::uintmax_t sum = 0;
  for (const DroppedFile& file : files) sum += file.bytes.size();
  const std::uintmax_t kept = bytes_below(folder);
  require(kept + sum <= kMostKept,
          "wanted files of at most {} MB in all, got {:.3g} MB beside {:.3g} MB of hands that were "
          "imported before: save the world and load it in a new session",
          kMostKept >> 20U, static_cast<double>(sum) / (1UL << 20U),
          static_cast<double>(kept) / (1UL << 20U));
}

/// Writes files into a folder, but for hidden ones. @returns their paths there in the order given
std::vector<fs::path> written(const fs::path& folder, const std::vector<DroppedFile>& files) {
  require(!files.empty() && files.size() <= kMostFiles, "wanted 1 to {} files, got {}", kMostFiles,
          files.size());
  // Write only below the folder, whatever the names say.
  const InsideFolder inside(folder.string());
  std::vector<fs::path> paths;
  for (const DroppedFile& file : files) {
    if (is_hidden(file.name)) continue;
    const fs::path path = checked_name(file.name);
    require(std::find(paths.begin(), paths.end(), path) == paths.end(),
            "the file '{}' was dropped twice", file.name);
    inside.write(path.string(), file.bytes);
    paths.push_back(path);
  }
  return paths;
}

/// A text with some words in place of others, wherever they stand.
std::string with_words(std::string text, const std::string& old, const std::string& words) {
  for (std::size_t at = text.find(old); at != std::string::npos;
       at = text.find(old, at + words.size()))
    text.replace(at, old.size(), words);
  return text;
}

/// Adds the thing of files that were written to a folder.
AddedThing add_written(LiveWorld& live, const fs::path& folder, const std::vector<fs::path>& files,
                       DroppedAs as, const Progress& progress, const std::string& units) {
  const std::string file = (folder / main_file(files, as)).string();
  if (as == DroppedAs::kHand) return add_hand(live, file, {}, progress);
  ImportedBody imported = imported_body(file, is_mesh_file(file) ? units : "");
  AddedThing added =
      add_body(live, {std::move(imported.body), "", {}, as == DroppedAs::kObject}, {});
  added.warnings.insert(added.warnings.begin(), imported.warnings.begin(), imported.warnings.end());
  return added;
}

}  // namespace

ImportedBody imported_body(const std::string& file, const std::string& units) {
  // Repair the surface, and give meshes a material, without which they have no mass.
  ImportRequest request;
  request.file = file;
  request.repair = true;
  request.units = units;
  if (is_mesh_file(file)) request.material = kDefaultMaterial;
  Imported imported = import_file(request);
  ImportedBody out{{}, std::move(imported.outcome.warnings)};
  if (imported.body)
    out.body = std::move(*imported.body);
  else if (auto* body = std::get_if<BodySpec>(&imported.thing))
    out.body = std::move(*body);
  else
    throw InputError(fmt::format("'{}' is a {} and no object", fs::path(file).filename().string(),
                                 imported.kind));
  // Its triangles stay, where they came from goes.
  out.body.files.clear();
  for (ShapeSpec& shape : out.body.shapes) {
    shape.mesh_file.clear();
    shape.mesh_scale = 1;
  }
  return out;
}

AddedThing import_dropped(LiveWorld& live, const std::vector<DroppedFile>& files, DroppedAs as,
                          const Progress& progress, const std::string& units) {
  require_room(live.own_folder(), files);
  // The folder goes away unless the hand is kept.
  DropFolder folder(live.own_folder());
  const auto told = [&](const std::string& text) {
    // The folder means nothing to who reads it.
    return with_words(with_words(text, folder.path().string() + "/", ""), "numbers millimetres?",
                      "numbers millimetres? Then import it with units of mm");
  };
  try {
    AddedThing added =
        add_written(live, folder.path(), written(folder.path(), files), as, progress, units);
    for (std::string& warning : added.warnings) warning = told(warning);
    const auto hidden = std::count_if(files.begin(), files.end(),
                                      [](const DroppedFile& file) { return is_hidden(file.name); });
    if (hidden > 0)
      added.warnings.push_back(
          fmt::format("{} hidden files, whose names begin with a dot, were left out", hidden));
    // A hand is built again from there when undone steps come back, and saved from there.
    if (as == DroppedAs::kHand) folder.keep();
    return added;
  } catch (const Stopped&) {
    throw;
  } catch (const Error& error) {
    throw InputError(told(error.what()));
  }
}

}  // namespace thenar
