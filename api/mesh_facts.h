#pragma once

/// A mesh, looked at: whether it bounds a solid, what that weighs, and whether its size is
/// plausible.

#include <cstddef>
#include <string>
#include <vector>

#include "data/io/mesh/mesh_file.h"
#include "geometry/mass_properties.h"
#include "geometry/mesh_check.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// A mesh, looked at.
struct MeshFacts {
  MeshReport surface;                 // as it is now
  std::size_t parts = 0;              // connected [1]
  std::size_t closed = 0;             // holes that were closed [1]
  std::string repaired;               // what was mended, in words; empty: nothing
  bool solid = false;                 // whether it bounds a volume
  MassProperties unit_mass;           // of the union of its parts at 1 kg/m^3; where it is solid
  std::vector<std::string> warnings;  // what is doubtful of it
};

/// Looks at a mesh: surface, parts, volume and its moments, of exact shapes where the file has
/// them.
[[nodiscard]] MeshFacts look_at_mesh(const MeshContent& content);

/// "box of 120 m: are its numbers millimetres?", a sentence for each shape of an implausible size.
/// @param owner  in words: "object 'mug'"
[[nodiscard]] std::vector<std::string> size_warnings(const std::vector<ShapeSpec>& shapes,
                                                     const std::string& owner);

}  // namespace thenar
