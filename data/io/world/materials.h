#pragma once

/// Materials, and friction between them.

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace thenar {

/// Dry friction between two materials.
struct Friction {
  double static_coefficient;   // [1]
  double kinetic_coefficient;  // [1]
};

/// One material.
struct Material {
  std::string name;
  double density = 0;          // [kg/m^3]; 0 if unknown
  double young = 0;            // of its soft layer [Pa]; 0: rigid
  double layer_thickness = 0;  // of its soft layer [m]; 0: rigid
};

/// Material of a surface whose material is not stated: hard and rather smooth.
inline constexpr const char* kDefaultMaterial = "plastic";

/// A table of materials and friction.
struct Materials {
  std::vector<Material> materials;
  std::map<std::pair<std::string, std::string>, Friction> friction;  // names in alphabetic order

  /// A material by name. @throws InputError if there is none, listing the names.
  [[nodiscard]] const Material& at(const std::string& name) const;
  /// Friction of a pair. @throws InputError if the pair has none.
  [[nodiscard]] Friction between(const std::string& a, const std::string& b) const;
};

/// Reads a table of materials; the format is in docs/data_format.md.
/// @param below  table that holds where the file states nothing: its materials and pairs
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] Materials read_materials(const std::string& path, const Materials& below = {});
[[nodiscard]] Materials parse_materials(const std::string& text, const std::string& path,
                                        const Materials& below = {});

/// The table that comes with thenar, data/materials.toml. "frictionless" slides on everything;
/// "skin" has measured friction with metal, rubber and sandpaper, and assumed values with the rest.
/// Source: [GraspItWorld] for hard materials and rubber, [Seo2009] and [Savescu2008] for skin.
[[nodiscard]] const Materials& built_in_materials();

}  // namespace thenar
