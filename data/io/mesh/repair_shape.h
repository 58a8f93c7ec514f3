#pragma once

/// Repair of meshes in shapes, so that they bound solids.

#include <string>
#include <vector>

#include "geometry/shape_spec.h"

namespace thenar {

/// Repairs the mesh of a shape (repair_to_solid()) if it bounds no solid; the mesh then no longer
/// refers to its file. `warnings` receives the repairs, or the failure. Other shapes are unchanged.
/// @param owner  in words: "link 'palm'"
/// @returns false if the mesh cannot become a solid, for example if it is flat.
[[nodiscard]] bool repair_shape(ShapeSpec& shape, const std::string& owner,
                                std::vector<std::string>& warnings);

/// Calls repair_shape() for each shape; shapes that cannot be repaired are removed.
void repair_shapes(std::vector<ShapeSpec>& shapes, const std::string& owner,
                   std::vector<std::string>& warnings);

/// Warns of meshes with inconsistently oriented triangles, which are reoriented when a solid is
/// built.
void note_turned(const std::vector<ShapeSpec>& shapes, const std::string& owner,
                 std::vector<std::string>& warnings);

/// Checks that a mesh bounds a solid (solid_parts()).
/// @throws InputError with its file and its holes otherwise.
void require_solid(const ShapeSpec& shape, const std::string& owner);

}  // namespace thenar
