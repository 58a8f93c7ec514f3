#include "data/io/world/materials.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "base/error.h"
#include "base/nearest_name.h"
#include "data/io/toml_table.h"

namespace thenar {

const Material& Materials::at(const std::string& name) const {
  std::string names;
  for (const Material& material : materials) {
    if (material.name == name) return material;
    names += (names.empty() ? "" : ", ") + material.name;
  }
  throw InputError(fmt::format("no material '{}'; there are {}", name, names));
}

Friction Materials::between(const std::string& a, const std::string& b) const {
  require(!a.empty() && !b.empty(),
          "no friction between '{}' and '{}': one of these links or bodies has no 'material'", a,
          b);
  const auto found = friction.find(std::minmax(a, b));
  require(found != friction.end(), "no friction between '{}' and '{}': give it in a materials file",
          a, b);
  return found->second;
}

namespace internal {
const std::map<std::string, std::string_view>& material_table();  // made by cmake/embed.cmake
}

namespace {

std::vector<std::string> names_of(const Materials& materials) {
  std::vector<std::string> names;
  for (const Material& material : materials.materials) names.push_back(material.name);
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Material read_material(TomlTable& table) {
  Material material;
  material.name = table.text("name");
  material.density = table.number_or(Dimension::kDensity, "density", 0, Range::kPositive);
  material.young = table.number_or(Dimension::kStress, "young", 0, Range::kPositive);
  if (material.young > 0)
    material.layer_thickness =
        table.number(Dimension::kLength, "layer_thickness", Range::kPositive);
  table.done();
  return material;
}

/// Reads the two materials of a pair. @param known  names that it may have
std::pair<std::string, std::string> read_pair(TomlTable& table,
                                              const std::vector<std::string>& known) {
  const std::vector<std::string> names = table.texts("between");
  if (names.size() != 2)
    table.fail(fmt::format("wanted 2 materials in 'between', got {}", names.size()), "between");
  for (const std::string& name : names)
    if (!contains(known, name))
      table.fail(fmt::format("no material '{}'{}", name, did_you_mean(name, known)), "between");
  return std::minmax(names[0], names[1]);
}

Friction read_friction(TomlTable& table) {
  const Friction friction{table.number(Dimension::kNumber, "static", Range::kNotNegative),
                          table.number(Dimension::kNumber, "kinetic", Range::kNotNegative)};
  if (friction.kinetic_coefficient > friction.static_coefficient)
    table.fail(fmt::format("kinetic friction {} is above the static {}",
                           friction.kinetic_coefficient, friction.static_coefficient),
               "kinetic");
  table.done();
  return friction;
}

}  // namespace

Materials parse_materials(const std::string& text, const std::string& path,
                          const Materials& below) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  top.ignore("name");
  Materials read;
  // Materials of this file, then those below that it does not replace.
  for (TomlTable& table : top.tables("material")) {
    const Material material = read_material(table);
    if (contains(names_of(read), material.name))
      table.fail(fmt::format("material '{}' is given twice", material.name), "name");
    read.materials.push_back(material);
  }
  for (const Material& material : below.materials)
    if (!contains(names_of(read), material.name)) read.materials.push_back(material);
  // Pairs of this file come before those below.
  const std::vector<std::string> known = names_of(read);
  for (TomlTable& table : top.tables("friction")) {
    const std::pair<std::string, std::string> pair = read_pair(table, known);
    if (!read.friction.emplace(pair, read_friction(table)).second)
      table.fail(fmt::format("friction between {} and {} is given twice", pair.first, pair.second));
  }
  top.done();
  read.friction.insert(below.friction.begin(), below.friction.end());
  return read;
}

Materials read_materials(const std::string& path, const Materials& below) {
  return parse_materials(read_text_file(path), path, below);
}

const Materials& built_in_materials() {
  static const Materials materials = parse_materials(
      std::string(internal::material_table().at("materials.toml")), "data/materials.toml", {});
  return materials;
}

}  // namespace thenar
