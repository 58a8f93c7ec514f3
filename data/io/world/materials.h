#pragma once

/// Materials, and friction between them.

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/provenance.h"

namespace thenar {

class ContactLaw;
struct FoundationConstants;

/// Dry friction between two materials.
struct Friction {
  double static_coefficient;   // [1]
  double kinetic_coefficient;  // [1]
};

/// One material.
struct Material {
  std::string name;
  double density = 0;          // [kg/m^3]; 0 if unknown
  double young = 0;            // Young's modulus of its soft layer [Pa]; 0: rigid
  double layer_thickness = 0;  // thickness of its soft layer [m]; 0: rigid
  std::string like;            // material whose friction it has where it has none; empty: none
  std::string laws_file;       // laws file of the pad that its layer is, as written; empty: none
  // The soft finger of that file, constant and shared by copies of the table; null: the layer is a
  // bed of springs.
  std::shared_ptr<const ContactLaw> law = nullptr;
  // Its bed of springs by the same file; null: springs of `young` and `layer_thickness`.
  std::shared_ptr<const FoundationConstants> bed = nullptr;
};

/// Material of a surface whose material is not stated: hard and rather smooth.
inline constexpr const char* kDefaultMaterial = "plastic";

/// A table of materials and friction.
struct Materials {
  std::vector<Material> materials;
  std::map<std::pair<std::string, std::string>, Friction> friction;  // names in alphabetic order
  FileDigests files = {};  // laws of pads that were read for it

  /// Returns a material by name. @throws InputError if there is none, listing the names.
  [[nodiscard]] const Material& at(const std::string& name) const;
  /// Returns the friction of a pair; where it has none, that of the materials that both are like,
  /// the first's before the second's. @throws InputError if there is none either.
  [[nodiscard]] Friction between(const std::string& a, const std::string& b) const;
};

/// Reads a table of materials; the format is in docs/data_format.md.
/// @param below  table that holds where the file states nothing: its materials and pairs
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] Materials read_materials(const std::string& path, const Materials& below = {});
[[nodiscard]] Materials parse_materials(const std::string& text, const std::string& path,
                                        const Materials& below = {});

/// Returns the table that comes with thenar, data/materials.toml. "frictionless" slides on
/// everything; "skin" has measured friction with metal, rubber and sandpaper, and assumed values
/// with the rest; "fingertip" is skin over the pad of data/pads/laws/index_pad.toml. Source:
/// [GraspItWorld] for hard materials and rubber, [Seo2009] and [Savescu2008] for skin.
[[nodiscard]] const Materials& built_in_materials();

}  // namespace thenar
