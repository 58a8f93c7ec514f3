#include "api/named/material_names.h"

#include <algorithm>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "api/named/files.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/nearest_name.h"

namespace thenar {
namespace {

/// Number of the first line of a file that states a material of this name, or else has the name in
/// quotes; 1 if none has it.
long line_of_name(const std::string& file, const std::string& name) {
  if (!is_file(file)) return 1;
  std::istringstream text(read_source(file).text);
  long number = 0, quoted = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    // The name in quotes may belong to a body; a line that states a material is the better find.
    if (line.find('"' + name + '"') == std::string::npos) continue;
    if (line.find("material") != std::string::npos) return number;
    if (quoted == 0) quoted = number;
  }
  return std::max(1L, quoted);
}

}  // namespace

Materials materials_of_file(const std::string& file) {
  if (file.empty()) return built_in_materials();
  require_kind(file, {"materials"});
  return read_materials(file, built_in_materials());
}

std::vector<std::string> unknown_materials(const std::string& file,
                                           const std::vector<std::string>& used,
                                           const Materials& table) {
  // Complain once about each name, however many bodies use it.
  const std::vector<std::string> names = names_of(table.materials);
  std::vector<std::string> complaints;
  for (const std::string& name : std::set<std::string>(used.begin(), used.end()))
    if (!name.empty() && !contains(names, name))
      complaints.push_back(fmt::format("{}:{}: no material '{}'{}", file, line_of_name(file, name),
                                       name, did_you_mean(name, names)));
  return complaints;
}

void require_materials(const NamedHand& hand, const Materials& table) {
  const std::vector<std::string> used = transformed(
      hand.hand->surfaces(), [&](const LinkSurface& surface) { return surface.material; });
  const std::vector<std::string> unknown =
      unknown_materials(hand.file.empty() ? hand.name : hand.file, used, table);
  require(unknown.empty(), "{}; a materials file may give others",
          unknown.empty() ? "" : unknown.front());
}

}  // namespace thenar
