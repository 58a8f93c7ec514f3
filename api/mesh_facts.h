#pragma once

/// Facts of a mesh: the solid that it bounds, its mass properties, and whether its size is
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

/// Largest plausible size of an object: a larger one is probably in another unit [m].
inline constexpr double kMaxObjectSize = 10;

/// Facts of a mesh.
struct MeshFacts {
  MeshReport surface;                 // surface after repair
  MeshFaults faults;                  // faults that cause its holes
  std::size_t parts = 0;              // connected parts [1]
  std::size_t closed = 0;             // closed holes [1]
  std::string repaired;               // description of repairs; empty: none
  double across = 0;                  // longest edge of its box [m]
  bool solid = false;                 // the surface bounds a volume
  MassProperties unit_mass;           // of the union of parts at 1 kg/m^3, if solid
  std::vector<std::string> warnings;  // doubts about the mesh
};

/// Computes surface, parts, volume and its moments, of exact shapes where the file has them.
[[nodiscard]] MeshFacts compute_mesh_facts(const MeshContent& content);

/// Returns a sentence for each shape of an implausible size: "box of 120 m: are its numbers
/// millimetres?".
/// @param owner  in words: "object 'mug'"
[[nodiscard]] std::vector<std::string> size_warnings(const std::vector<ShapeSpec>& shapes,
                                                     const std::string& owner);

/// Returns "object 'cone': 1466 g/cm3: is its mass in grams?", where a stated mass or density is
/// beyond 0.01 .. 25 g/cm3 (aerogels and foams; osmium has 22.6); else nothing.
[[nodiscard]] std::vector<std::string> density_warnings(const BodySpec& body,
                                                        const std::string& owner);

}  // namespace thenar
