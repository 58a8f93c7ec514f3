#pragma once

/// What things are made of, and how they slide on each other.

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

/// What a surface is taken to be made of where nothing says it: hard and rather smooth.
inline constexpr const char* kDefaultMaterial = "plastic";

struct Materials {
  std::vector<Material> materials;
  std::map<std::pair<std::string, std::string>, Friction> friction;  // names in alphabetic order

  /// @throws InputError if there is no such material, listing those there are.
  [[nodiscard]] const Material& at(const std::string& name) const;
  /// @throws InputError if the pair has no friction.
  [[nodiscard]] Friction between(const std::string& a, const std::string& b) const;
};

/// Reads a table of materials; the format is in docs/data_format.md.
/// @param below  what holds where the file says nothing: its materials and pairs
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] Materials read_materials(const std::string& path, const Materials& below = {});
[[nodiscard]] Materials parse_materials(const std::string& text, const std::string& path,
                                        const Materials& below = {});

/// The table that comes with thenar, data/materials.toml. "frictionless" slides on everything;
/// "skin" has measured friction with metal, rubber and sandpaper, and stand-ins for the rest.
/// Source: [GraspItWorld] for hard materials and rubber, [Seo2009] and [Savescu2008] for skin.
[[nodiscard]] const Materials& built_in_materials();

}  // namespace thenar
