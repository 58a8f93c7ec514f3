#pragma once

/// A mesh, looked at: whether it bounds a solid, what that weighs, and whether its size is
/// plausible.

#include <cstddef>
#include <string>
#include <vector>

#include "data/io/mesh/mesh_file.h"
#include "data/io/world/world.h"
#include "geometry/mass_properties.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_faults.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// Largest plausible size of a thing: a larger one is in another unit [m].
inline constexpr double kLargestThing = 10;

/// A mesh, looked at.
struct MeshFacts {
  MeshReport surface;                 // as it is now
  MeshFaults faults;                  // what its holes come from
  std::size_t parts = 0;              // connected [1]
  std::size_t closed = 0;             // holes that were closed [1]
  std::string repaired;               // what was mended, in words; empty: nothing
  double across = 0;                  // longest edge of its box [m]
  bool solid = false;                 // whether it bounds a volume
  MassProperties unit_mass;           // of the union of its parts at 1 kg/m^3; where it is solid
  std::vector<std::string> warnings;  // what is doubtful of it
};

/// Looks at a mesh: surface, parts, volume and its moments, of exact shapes where the file has
/// them.
[[nodiscard]] MeshFacts look_at_mesh(const MeshContent& content);

/// Returns "box of 120 m: are its numbers millimetres?", a sentence for each shape of an
/// implausible size.
/// @param owner  in words: "object 'mug'"
[[nodiscard]] std::vector<std::string> size_warnings(const std::vector<ShapeSpec>& shapes,
                                                     const std::string& owner);

/// Returns "object 'cone': 1466 g/cm3: is its mass in grams?", where a stated mass or density is
/// beyond 0.01 .. 25 g/cm3 (aerogels and foams; osmium has 22.6); else nothing.
[[nodiscard]] std::vector<std::string> density_warnings(const BodySpec& body,
                                                        const std::string& owner);

}  // namespace thenar
