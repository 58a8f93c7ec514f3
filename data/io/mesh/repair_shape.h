#pragma once

/// Meshes in shapes, made solid.

#include <string>
#include <vector>

#include "geometry/shape_spec.h"

namespace thenar {

/// Mends the mesh of a shape (repair_to_solid()) if it bounds no solid; it then no longer stands
/// for its file. What was done, or that nothing helps, is in `warnings`. Other shapes stay as they
/// are.
/// @param owner  whose it is, in words: "link 'palm'"
/// @return false if the mesh can be no solid, as one that is flat.
[[nodiscard]] bool repair_shape(ShapeSpec& shape, const std::string& owner,
                                std::vector<std::string>& warnings);

/// repair_shape() of each; those that can be no solid are left out.
void repair_shapes(std::vector<ShapeSpec>& shapes, const std::string& owner,
                   std::vector<std::string>& warnings);

/// Warns of meshes whose triangles face opposite ways, which are turned wherever a solid is wanted.
void note_turned(const std::vector<ShapeSpec>& shapes, const std::string& owner,
                 std::vector<std::string>& warnings);

/// Refuses a mesh that bounds no solid (solid_parts()), naming its file and its holes.
/// @throws InputError
void require_solid(const ShapeSpec& shape, const std::string& owner);

}  // namespace thenar
