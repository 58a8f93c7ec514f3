#pragma once

/// Bodies of GraspIt!.

#include <string>
#include <vector>

#include "data/io/mesh/mesh_file.h"
#include "data/io/world/world.h"

namespace thenar {

/// A body that was imported, with elements that were not understood.
struct GraspitBody {
  BodySpec body;
  std::vector<std::string> warnings;  // "path:line: ..."
};

/// Reads a body in GraspIt! XML: <material>, <mass> [g], <cog> [mm], <inertia_matrix> per mass
/// [mm^2], and one <geometryFile> beside it, in mm or the unit of its attribute `Units`, times its
/// attribute `scale` and <geometryScaling>, placed by <geometryOffset>. A mesh file is a body in
/// mm. The body is named after its file; the path of the mesh is absolute, so that the body can be
/// written anywhere.
/// @throws DataError if it is no body, or its mesh cannot be read.
/// Source: [GraspItWorld] for the format.
[[nodiscard]] GraspitBody read_graspit_body(const std::string& path);
/// Reads a body with a mesh reader that other bodies share.
[[nodiscard]] GraspitBody read_graspit_body(const std::string& path, MeshReader& meshes);

}  // namespace thenar
