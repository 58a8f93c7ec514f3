#include "api/named/things.h"

#include <filesystem>

#include <fmt/format.h>

#include "api/named/data_folders.h"
#include "api/named/portable_world.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/name_hint.h"
#include "base/run_record.h"
#include "data/io/result_layout.h"
#include "data/io/robot/import_robot.h"
#include "posterior/run/posterior_file.h"

namespace thenar {
namespace {

/// Names of things of all kinds.
std::vector<std::string> all_names(const std::vector<std::string>& places) {
  std::vector<std::string> names;
  for (const ThingKind& kind : thing_kinds())
    append_all(names, names_in(places, kind.folder, kind.ending));
  return names;
}

/// A motion of a digit or a run of a scene.
ResultFile read_run(const std::string& path) {
  ResultFile file = read_result(path);
  if (!has_layout(file))
    throw DataError(path, 1,
                    fmt::format("wanted a motion or a run of a scene, got a file of format '{}'",
                                file.text_or_none("format")));
  return file;
}

Thing read_robot_of(const std::string& path, const std::string& format) {
  return format == "TOML" ? read_robot(path) : import_robot(path);
}

}  // namespace

const std::vector<ThingKind>& thing_kinds() {
  static const std::vector<ThingKind> kinds{
      {"subjects", "subject", "subjects", ".toml"},
      {"experiments", "experiment", "experiments", ".toml"},
      {"worlds", "world", "worlds", ".toml"},
      {"scenes", "scene", "scenes", ".toml"},
      {"hands", "robot", "robots", ".toml"},
      {"objects", "object", "objects", ".toml"},
      {"pads", "pad", "pads", ".toml"},
      {"nets", "net", "nets", ".toml"},
      {"contacts", "contacts", "contacts", ".json"},
      {"settings", "fit settings", "fits", ".toml"},
      {"proportions", "proportions", "anthropometry", ".toml"}};
  return kinds;
}

std::string named_thing(const std::string& name_or_path, const std::string& data) {
  std::error_code none;
  // A path beats a name; among names the order of the kinds decides.
  if (std::filesystem::exists(name_or_path, none)) return name_or_path;
  const std::vector<std::string> places = data_folders(data);
  for (const ThingKind& kind : thing_kinds()) {
    std::string found = find_in(places, kind.folder + "/" + name_or_path + kind.ending);
    if (!found.empty()) return found;
  }
  // A path that does not exist gets the message about files, with the nearest file as a hint.
  const std::filesystem::path path = name_or_path;
  if (path.has_parent_path() || path.has_extension()) (void)contents_of(name_or_path);
  throw InputError(
      fmt::format("there is no file '{0}', nor a subject, experiment, world, scene, "
                  "hand, object, pad or net of that name{1} `thenar list` shows all names",
                  name_or_path, hint_before_list(name_or_path, all_names(places))));
}

Thing read_thing(const std::string& path) {
  const FileContents file = contents_of(path);
  if (!is_file(path)) (void)read_source(path);  // a pipe or a device: refused, saying which
  // Files that thenar's own formats describe, kind by kind.
  if (file.kind == "subject") return read_subject(path);
  if (file.kind == "experiment") return read_experiment(path);
  if (file.kind == "fit settings") return read_fit_settings(path);
  if (file.kind == "proportions") return read_proportions(path);
  if (file.kind == "variability of axes") return read_variability(path);
  if (file.kind == "losses of pinch") return read_pinch_losses(path);
  if (file.kind == "net") return read_net(path);
  if (file.kind == "materials") return read_materials(path, built_in_materials());
  if (file.kind == "robot") return read_robot_of(path, file.format);
  if (file.kind == "object" && file.format == "TOML") return read_object(path);
  if (file.kind == "world" && file.format == "TOML") return read_world_at(path, "");
  if (file.kind == "scene") return read_scene_at(path, "");
  if (file.kind == "pad") return read_pad(path);
  if (file.kind == "laws of a pad") return read_laws(path);
  if (file.kind == "presses of a pad") return read_pad_data(path);
  if (file.kind == "fit") return read_fit(path);
  if (file.kind == "posterior") return read_posterior(path);
  if (file.kind == "motion" || file.kind == "scene run") return read_run(path);
  // Files of foreign formats belong to `thenar import`; say so rather than fail in a parser.
  if (file.format == "HDF5") return read_fit(path);  // damaged: its reader says how
  if (file.format.find("XML") != std::string::npos && !file.kind.empty())
    throw InputError(fmt::format("'{}' is a {} of another format: thenar import {} reads it", path,
                                 file.kind, shell_word(path)));
  require_kind(path, {"data file (TOML, HDF5, netCDF)"});
  throw DataError(path, 1,
                  "wanted TOML or HDF5; robots, objects, worlds and meshes of other formats are "
                  "read by `thenar import`, lists of contacts (JSON) by `thenar quality`");
}

}  // namespace thenar
