#include "api/named/files.h"

#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/named/data_folders.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/words.h"
#include "data/io/checked_file.h"
#include "data/io/file_guard.h"
#include "data/io/file_kind.h"
#include "data/io/graspit/xml_file.h"
#include "data/io/hdf5_guard.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/import_robot.h"
#include "data/io/toml_node.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// Finds the kind of an HDF5 file by the names in it; none of its values is read.
FileContents of_hdf5(const std::string& path) {
  // Strangers' files may crash the library, so they are first opened in a process of their own.
  std::vector<std::string> keys;
  try {
    std::string bytes = read_guarded(path, GuardedKind::kResult);
    try_in_fork(path, seconds_to_read(bytes.size()), [&] { (void)guard_hdf5(bytes, path); });
    keys = guard_hdf5(bytes, path);
  } catch (const Error&) {
    return {"", "HDF5"};  // damaged
  }
  // Tell kinds apart by groups that only one of them has.
  const auto has = [&](const std::string& start) {
    return any_of(keys, [&](const std::string& key) { return starts_with(key, start); });
  };
  if (has("fit/z")) return {"fit", "HDF5"};
  if (has("unconstrained_posterior/") || has("posterior/")) return {"posterior", "netCDF"};
  if (has("excitation") && has("excursion")) return {"motion", "HDF5"};
  if (has("scene")) return {"scene run", "HDF5"};
  return {"", "HDF5"};
}

FileContents of_robot(const std::string& path) {
  try {
    return {"robot", name_of(find_robot_kind(path))};
  } catch (const DataError&) {
    return {"", "XML"};
  }
}

FileContents of_xml(const std::string& path, const std::string& start) {
  std::string root;
  try {
    root = XmlFile(path).root_name();
  } catch (const DataError&) {
    return {"", "XML"};  // broken
  }
  // Distinguish GraspIt! worlds, URDF and MJCF by the root element.
  if (root == "world") return {"world", "GraspIt! XML"};
  if (root == "robot" || root == "mujoco" || root == "mujocoinclude") return of_robot(path);
  if (start.find("<geometryFile") != std::string::npos) return {"object", "GraspIt! XML"};
  return {"", "XML"};
}

/// Finds the kind of a JSON file by names of members in its first part.
FileContents of_json(const std::string& start) {
  const auto has = [&](const char* member) {
    return start.find(fmt::format("\"{}\"", member)) != std::string::npos;
  };
  if (has("contacts") && (has("torque_scale") || has("position") || has("wrenches")))
    return {"contacts", "JSON"};
  if (has("torque_scale_m") && has("centre_of_mass_m")) return {"contacts", "JSON"};  // a grasp
  if (has("inputs") && has("approaches") && has("objects")) return {"comparison", "JSON"};
  if (has("provenance")) return {"answer", "JSON"};
  return {"", "JSON"};
}

FileContents of_html(const std::string& path) {
  const std::string text = read_source(path).text;
  const bool page = text.find("id=\"thenar-report\"") != std::string::npos;
  return {page ? "page" : "", "HTML"};
}

FileContents look_into(const std::string& path) {
  constexpr std::size_t kStartBytes = 1 << 16;  // Size of the start that is read [bytes]
  // HDF5 files have a signature of their own, so their ending does not matter.
  if (has_hdf5_start(path)) return of_hdf5(path);
  const std::string ending = fs::path(path).extension();
  if (ending == ".toml") return {name_of(find_file_kind(path)), "TOML"};
  if (is_mesh_file(path)) return {"mesh", ending.substr(1)};
  // Recognise other formats by their ending or their first character.
  const std::string start = read_start(path, kStartBytes);
  if (ending == ".html" || ending == ".htm") return of_html(path);
  if (first_sign(start) == '<') return of_xml(path, start);
  if (first_sign(start) == '{') return of_json(start);
  // A text without a known ending may still be TOML.
  try {
    return {name_of(find_file_kind(path)), "TOML"};
  } catch (const DataError&) {
    return {"", ""};
  }
}

/// "there is no file 'fit1.h5', did you mean 'fit.h5'?"
std::string absent(const std::string& path) {
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : ".";
  // By the stem: an ending in common says little.
  std::map<std::string, std::string> by_stem;
  std::vector<std::string> stems;
  // Prefer the requested ending among files of the same stem.
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    const fs::path name = entry.path().filename();
    stems.push_back(name.stem().string());
    std::string& file = by_stem[stems.back()];
    if (file.empty() || name.extension() == fs::path(path).extension()) file = name.string();
  }
  const std::string stem = nearest_name(fs::path(path).stem().string(), stems);
  return fmt::format("there is no file '{}'{}", path,
                     stem.empty() ? "" : fmt::format(", did you mean '{}'?", by_stem.at(stem)));
}

std::string with_article(const std::string& kind) {
  if (kind == "contacts") return "a contact set";
  const bool none = kind == "materials" || kind == "fit settings" || kind == "proportions" ||
                    kind == "presses of a pad" || kind == "laws of a pad";
  const bool vowel = std::string("aeiou").find(kind.front()) != std::string::npos;
  return (none ? "" : vowel ? "an " : "a ") + kind;
}

}  // namespace

SourceText read_source(const std::string& path) { return {path, read_text_file(path)}; }

std::vector<std::string> checksum_warnings(const std::string& path) {
  if (!has_hdf5_start(path) || has_checksum(path)) return {};
  return {path + ": it has no checksum, so that damage cannot be noticed"};
}

void require_result_path(const std::string& path) {
  // A file that is no result of thenar is never overwritten, whatever its ending.
  const auto is_result = [&] {
    try {
      return find_file_kind(path) == FileKind::kResult;
    } catch (const DataError&) {
      return false;
    }
  };
  std::error_code none;
  require(!fs::exists(path, none) || is_result(),
          "'{}' exists and is not a result file of thenar; it is not overwritten", path);
  require_writable(path);
}

FileContents contents_of(const std::string& path) {
  std::error_code none;
  require(fs::exists(path, none), "{}", absent(path));
  if (fs::is_directory(path, none)) return {"folder", ""};
  if (!is_file(path)) return {};  // a pipe or a device: whoever reads it says so
  return look_into(path);
}

std::string requested_file(const char* field, const std::string& kind, const std::string& name,
                           const std::string& folder, const std::string& data,
                           const std::string& hint) {
  return in_field(field, [&] {
    std::string file = named_file(kind, name, folder, ".toml", data_folders(data));
    require_kind(file, {kind}, hint);
    return file;
  });
}

void require_kind(const std::string& path, const std::vector<std::string>& kinds,
                  const std::string& hint) {
  FileContents found;
  try {
    found = contents_of(path);
  } catch (const DataError&) {
    return;  // the reader reports the error
  }
  if (found.kind.empty() || contains(kinds, found.kind)) return;
  // Name the found kind and the accepted kinds.
  const std::vector<std::string> wanted =
      transformed(kinds, [](const std::string& kind) { return with_article(kind); });
  const bool part = found.kind == "robot" || found.kind == "object" || found.kind == "mesh";
  throw WrongKindError(fmt::format("'{}' is {}, wanted {}", path, with_article(found.kind),
                                   fmt::join(wanted, " or ")),
                       found.kind, path, part && !hint.empty() ? "; " + hint : "");
}

}  // namespace thenar
