#include "data/io/world/materials.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string_view>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "data/io/linked_file.h"
#include "data/io/pad/law_file.h"
#include "data/io/toml_table.h"
#include "pad_laws/point_laws.h"

namespace thenar {
namespace {

/// A material, the one that it is like, and so on; each once.
std::vector<std::string> likenesses(const Materials& materials, const std::string& name) {
  std::vector<std::string> names{name};
  for (std::size_t i = 0; i < names.size(); ++i)
    for (const Material& material : materials.materials)
      if (material.name == names[i] && !material.like.empty() && !contains(names, material.like))
        names.push_back(material.like);
  return names;
}

}  // namespace

const Material& Materials::at(const std::string& name) const {
  if (const Material* found = find_named(materials, name)) return *found;
  throw InputError(
      fmt::format("no material '{}'; there are {}", name, fmt::join(names_of(materials), ", ")));
}

Friction Materials::between(const std::string& a, const std::string& b) const {
  require(!a.empty() && !b.empty(),
          "no friction between '{}' and '{}': one of these links or bodies has no 'material'", a,
          b);
  // The pair itself comes first, as each material is the first of its likenesses.
  for (const std::string& second : likenesses(*this, b))
    for (const std::string& first : likenesses(*this, a))
      if (const auto found = friction.find(std::minmax(first, second)); found != friction.end())
        return found->second;
  throw InputError(
      fmt::format("no friction between '{}' and '{}': give it in a materials file", a, b));
}

namespace internal {
const std::map<std::string, std::string_view>& material_table();  // made by cmake/embed.cmake
}

namespace {

/// Laws of a pad by the name that a materials file gives them.
using FindLaws = std::function<CalibratedLaws(TomlTable& table, const std::string& file)>;

/// Returns the material that 'like' names, of this file so far or of `below`; an empty material if
/// the key is absent.
Material read_likeness(TomlTable& table, const Materials& read, const Materials& below) {
  Material likeness;
  const std::string name = table.text_or("like", "");
  if (name.empty()) return likeness;
  std::vector<std::string> known = names_of(read.materials);
  for (const Materials* each : {&read, &below}) {
    if (const Material* found = find_named(each->materials, name)) {
      likeness = *found;
      likeness.like = name;
      return likeness;
    }
    append_all(known, names_of(each->materials));
  }
  table.fail(fmt::format("no material '{}' before it{}", name, did_you_mean(name, known)), "like");
}

Material read_material(TomlTable& table, Material material, const FindLaws& find_laws) {
  material.name = table.text("name");
  material.density =
      table.number_or(Dimension::kDensity, "density", material.density, Range::kPositive);
  // A layer of its own has no law of another's.
  if (table.has(Dimension::kStress, "young")) {
    material.young = table.number(Dimension::kStress, "young", Range::kPositive);
    material.layer_thickness =
        table.number(Dimension::kLength, "layer_thickness", Range::kPositive);
    material.laws_file = "";
    material.law = nullptr;
    material.bed = nullptr;
  }
  if (table.has("laws")) {
    if (material.young == 0)
      table.fail("wanted 'young' and 'layer_thickness' beside 'laws': how soft the pad is", "laws");
    material.laws_file = table.text("laws");
    const CalibratedLaws laws = find_laws(table, material.laws_file);
    material.law = std::make_shared<const SoftFinger>(laws.soft_finger, laws.relaxation);
    material.bed = std::make_shared<const FoundationConstants>(laws.foundation);
  }
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

Materials parse(const std::string& text, const std::string& path, const Materials& below,
                const FindLaws& find_laws) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  top.ignore("name");
  Materials read;
  // Materials of this file, then those below that it does not replace.
  for (TomlTable& table : top.tables("material")) {
    const Material material = read_material(table, read_likeness(table, read, below), find_laws);
    if (contains(names_of(read.materials), material.name))
      table.fail(fmt::format("material '{}' is given twice", material.name), "name");
    read.materials.push_back(material);
  }
  for (const Material& material : below.materials)
    if (!contains(names_of(read.materials), material.name)) read.materials.push_back(material);
  // Pairs of this file come before those below.
  const std::vector<std::string> known = names_of(read.materials);
  for (TomlTable& table : top.tables("friction")) {
    const std::pair<std::string, std::string> pair = read_pair(table, known);
    if (!read.friction.emplace(pair, read_friction(table)).second)
      table.fail(fmt::format("friction between {} and {} is given twice", pair.first, pair.second));
  }
  top.done();
  read.friction.insert(below.friction.begin(), below.friction.end());
  return read;
}

}  // namespace

Materials parse_materials(const std::string& text, const std::string& path,
                          const Materials& below) {
  // Laws are beside the file.
  FileDigests files = below.files;
  Materials read = parse(text, path, below, [&](TomlTable& table, const std::string& file) {
    const std::string whole =
        linked_file(table, "laws", file, std::filesystem::path(path).parent_path().string());
    files.merge(digests_of({whole}));
    return read_laws(whole);
  });
  read.files = std::move(files);
  return read;
}

Materials read_materials(const std::string& path, const Materials& below) {
  return parse_materials(read_text_file(path), path, below);
}

const Materials& built_in_materials() {
  static const Materials materials = [] {
    const auto& built_in = internal::material_table();
    return parse(std::string(built_in.at("materials.toml")), "data/materials.toml", {},
                 [&](TomlTable& /*table*/, const std::string& file) {
                   const std::string name = std::filesystem::path(file).filename().string();
                   return parse_laws(std::string(built_in.at(name)), "data/" + file);
                 });
  }();
  return materials;
}

}  // namespace thenar
