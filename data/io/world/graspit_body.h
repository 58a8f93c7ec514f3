#pragma once

/// Bodies of GraspIt!.

#include <string>
#include <vector>

#include "data/io/mesh/mesh_file.h"
#include "data/io/world/world.h"

namespace thenar {

/// What an importer read, and what it did not understand.
struct GraspitBody {
  BodySpec body;
  std::vector<std::string> warnings;  // "path:line: ..."
};

/// Reads a body in GraspIt! XML: <material>, <mass> [g], <cog> [mm], <inertia_matrix> over mass
/// [mm^2], and one <geometryFile>, found beside it, in mm or the unit of its attribute `Units`,
/// times its attribute `scale` and <geometryScaling>, placed by <geometryOffset>. A file that is
/// itself a mesh is a body in mm. The body is named after its file; the mesh's path is absolute, so
/// that the body may be written anywhere.
/// @throws DataError if it is no body, or its mesh cannot be read.
/// Source: [GraspItWorld] for the format.
[[nodiscard]] GraspitBody read_graspit_body(const std::string& path);
/// The same, of a world with other meshes.
[[nodiscard]] GraspitBody read_graspit_body(const std::string& path, MeshReader& meshes);

}  // namespace thenar
