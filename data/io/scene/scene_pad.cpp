#include "data/io/scene/scene_pad.h"

#include <map>
#include <set>
#include <string_view>

#include "base/error.h"
#include "base/nearest_name.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/pad/law_file.h"
#include "data/io/world/world_keys.h"

namespace thenar {

const std::vector<std::string>& pad_rung_names() {
  static const std::vector<std::string> names{"elements", "foundation", "soft-finger", "power-law",
                                              "hard-point"};
  return names;
}

namespace internal {

const std::map<std::string, std::string_view>& pad_table();      // made by cmake/embed.cmake
const std::map<std::string, std::string_view>& pad_law_table();  // the same

namespace {

using BuiltIn = std::map<std::string, std::string_view>;

/// Reads what a key names: something built in where the name has no ".toml", otherwise a file.
template <typename Parse, typename Read>
auto read_named(TomlTable& table, const std::string& key, const std::string& name,
                const BuiltIn& built_in, const std::string& folder, const Parse& parse,
                const Read& read) {
  const auto found = built_in.find(name + ".toml");
  if (found != built_in.end()) return parse(std::string(found->second), "data/pads/" + name);
  if (name.size() < 5 || name.substr(name.size() - 5) != ".toml") {
    std::vector<std::string> names;
    for (const auto& [file, text] : built_in) names.push_back(file.substr(0, file.size() - 5));
    table.fail(fmt::format("wanted '{}' a file .toml, or what is built in, got '{}'{}", key, name,
                           did_you_mean(name, names)),
               key);
  }
  return read(file_beside(table, key, folder));
}

void read_pad_files(TomlTable& table, const std::string& folder, ScenePadSpec& out) {
  const bool is_built_in = pad_table().count(out.pad + ".toml") > 0;
  out.spec = read_named(table, "pad", out.pad, pad_table(), folder, parse_pad, read_pad);
  if (is_built_in) out.spec.files.clear();
  out.files = out.spec.files;
  // Laws belong to their pad.
  if (out.laws.empty() && is_built_in) out.laws = out.pad;
  if (out.laws.empty()) return;
  out.law = read_named(table, "laws", out.laws, pad_law_table(), folder, parse_laws, read_laws);
  if (pad_law_table().count(out.laws + ".toml") == 0)
    out.files.merge(digests_of({file_beside(table, "laws", folder)}));
}

}  // namespace

ScenePadSpec read_scene_pad(TomlTable& table, const std::string& folder) {
  ScenePadSpec out;
  out.line = table.line();
  out.on = table.text("on");
  // Who presses on it.
  out.against = table.texts("against");
  if (out.against.empty()) table.fail("a pad needs a body that presses on it", "against");
  std::set<std::string> met{out.on};
  for (const std::string& name : out.against)
    if (!met.insert(name).second)
      table.fail(name == out.on ? fmt::format("'{}' cannot press on its own pad", name)
                                : fmt::format("'{}' is named twice", name),
                 "against");
  // What it is, and how fine.
  out.pad = table.text_or("pad", out.pad);
  out.laws = table.text_or("laws", "");
  if (table.has("rung")) out.rung = table.choice("rung", pad_rung_names());
  read_pad_files(table, folder, out);
  if (!out.law && out.rung != "elements" && out.rung != "hard-point")
    table.fail(fmt::format("the rung '{}' needs 'laws' of this pad", out.rung), "rung");
  // Where it is.
  const bool turned = table.has("rotation") || table.has("quaternion_wxyz") ||
                      table.has(Dimension::kAngle, "rpy") || table.has(Dimension::kAngle, "angle");
  const bool placed = table.has(Dimension::kLength, "position");
  if (turned && !placed) table.fail("a pad that is turned needs a 'position'");
  if (placed) out.X_BP = read_pose_keys(table);
  out.scale = number_if(table, Dimension::kNumber, "scale", Range::kPositive);
  if (out.spec.skin && out.scale && *out.scale != 1)
    table.fail("a pad with a mesh for its skin has no 'scale'", "scale");
  out.force_error =
      table.number_or(Dimension::kNumber, "force_error", out.force_error, Range::kPositive);
  out.friction = number_if(table, Dimension::kNumber, "friction", Range::kNotNegative);
  return out;
}

}  // namespace internal
}  // namespace thenar
