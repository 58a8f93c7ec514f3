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

constexpr std::size_t kMaxDroppedFiles = 1000;              // largest number of files of a drop
constexpr std::size_t kMaxFileNameBytes = 300;              // largest length of a file name [bytes]
constexpr std::uintmax_t kMaxImportedBytes = 256UL << 20U;  // largest size of all imports [bytes]

/// Checks the name of a dropped file. @return its path within the folder of the drop
/// @throws InputError if the name is too long or leads out of the folder
fs::path checked_name(const std::string& name) {
  require(name.size() <= kMaxFileNameBytes,
          "wanted names of dropped files of at most {} bytes, got {}", kMaxFileNameBytes,
          name.size());
  return outside_path(name, OutsideUse::kInside);
}

/// Returns true if the name of a file begins with a dot: ".DS_Store", "__MACOSX/._tip.stl".
bool is_hidden(const std::string& name) {
  const std::string last = name.substr(name.rfind('/') + 1);
  return last.size() > 1 && last.front() == '.' && last != "..";
}

/// Returns the extension of a path in lower case, ".stl".
std::string lower_case_extension(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool describes_robot(const fs::path& path) {
  static const std::set<std::string> endings{".urdf", ".xml", ".mjcf", ".toml"};
  return endings.count(lower_case_extension(path)) > 0;
}

bool describes_body(const fs::path& path) {
  return lower_case_extension(path) == ".toml" || lower_case_extension(path) == ".xml";
}

/// Finds the main file of a drop. @throws InputError if there is none
fs::path main_file(const std::vector<fs::path>& files, DroppedAs as) {
  // Prefer a description to a mesh, because it refers to the meshes beside it.
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

/// New folder of a drop; removed by the destructor unless keep() was called.
class DropFolder {
 public:
  explicit DropFolder(const std::string& parent) {
    // Take the lowest free number, so that equal sessions have equal names.
    for (int number = 1; path_.empty(); ++number)
      if (const fs::path next = fs::path(parent) / std::to_string(number); !fs::exists(next))
        path_ = next;
    std::error_code failed;
    fs::create_directory(path_, failed);
    require(!failed, "'{}' cannot be made: {}", path_.string(), failed.message());
  }
  ~DropFolder() {
    std::error_code ignored;  // the world removes the parent folder at the end
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

/// Returns the size of all files in a folder and below it [bytes].
std::uintmax_t bytes_below(const fs::path& folder) {
  std::uintmax_t sum = 0;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none))
    if (entry.is_regular_file(none)) sum += entry.file_size(none);
  return sum;
}

/// @throws InputError if files and the imports that the world keeps exceed kMaxImportedBytes
void require_capacity(const std::string& folder, const std::vector<DroppedFile>& files) {
  std::uintmax_t sum = 0;
  for (const DroppedFile& file : files) sum += file.bytes.size();
  const std::uintmax_t kept = bytes_below(folder);
  require(kept + sum <= kMaxImportedBytes,
          "wanted files of at most {} MB in all, got {:.3g} MB beside {:.3g} MB of hands that were "
          "imported before: save the world and load it in a new session",
          kMaxImportedBytes >> 20U, static_cast<double>(sum) / (1UL << 20U),
          static_cast<double>(kept) / (1UL << 20U));
}

/// Writes files into a folder, except for hidden ones. @return their paths in the folder, in order
std::vector<fs::path> store_files(const fs::path& folder, const std::vector<DroppedFile>& files) {
  require(!files.empty() && files.size() <= kMaxDroppedFiles, "wanted 1 to {} files, got {}",
          kMaxDroppedFiles, files.size());
  // InsideFolder refuses to write outside of the folder.
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

/// Replaces all occurrences of a text by another.
std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// Adds the object, obstacle or hand whose files were written to a folder.
AddedThing add_written(LiveWorld& live, const fs::path& folder, const std::vector<fs::path>& files,
                       DroppedAs as, const Progress& progress, const std::string& units) {
  const std::string file = (folder / main_file(files, as)).string();
  if (as == DroppedAs::kHand) return add_hand(live, file, {}, progress);
  ImportedBody imported = read_imported_body(file, is_mesh_file(file) ? units : "");
  AddedThing added =
      add_body(live, {std::move(imported.body), "", {}, as == DroppedAs::kObject}, {});
  added.warnings.insert(added.warnings.begin(), imported.warnings.begin(), imported.warnings.end());
  return added;
}

}  // namespace

ImportedBody read_imported_body(const std::string& file, const std::string& units) {
  // Import the file; repair the surface, and give meshes a material, without which they have no
  // mass.
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
  // Keep the triangles, and clear the references to files.
  out.body.files.clear();
  for (ShapeSpec& shape : out.body.shapes) {
    shape.mesh_file.clear();
    shape.mesh_scale = 1;
  }
  return out;
}

AddedThing import_dropped(LiveWorld& live, const std::vector<DroppedFile>& files, DroppedAs as,
                          const Progress& progress, const std::string& units) {
  require_capacity(live.own_folder(), files);
  DropFolder folder(live.own_folder());
  // Messages do not name the temporary folder, and say how to state units.
  const auto without_folder = [&](const std::string& text) {
    return replace_all(replace_all(text, folder.path().string() + "/", ""), "numbers millimetres?",
                       "numbers millimetres? Then import it with units of mm");
  };
  // Write the files, and add the thing.
  try {
    AddedThing added =
        add_written(live, folder.path(), store_files(folder.path(), files), as, progress, units);
    for (std::string& warning : added.warnings) warning = without_folder(warning);
    // Report hidden files.
    const auto hidden = std::count_if(files.begin(), files.end(),
                                      [](const DroppedFile& file) { return is_hidden(file.name); });
    if (hidden > 0)
      added.warnings.push_back(
          fmt::format("{} hidden files, whose names begin with a dot, were left out", hidden));
    // Keep the files of a hand: undo and redo may rebuild it, and saving the world copies them.
    if (as == DroppedAs::kHand) folder.keep();
    return added;
  } catch (const Stopped&) {
    throw;
  } catch (const Error& error) {
    throw InputError(without_folder(error.what()));
  }
}

}  // namespace thenar
