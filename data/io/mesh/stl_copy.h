#pragma once

/// Meshes that stand in no file, as STL files beside the file that names them.

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/shape_spec.h"

namespace thenar {

/// The surface as an STL file keeps it: corners in single precision, welded as they are read.
/// @throws DataError if no triangle is left of it
[[nodiscard]] TriangleMesh as_in_stl(const TriangleMesh& mesh);

/// Paths and contents of files, as write_files() takes them.
using WrittenFiles = std::vector<std::pair<std::string, std::string>>;

/// Gives each mesh that stands in no file one beside `out`, "hand_palm_0.stl", if it bounds as many
/// solids when it is read from there; else the triangles stay in the shape.
/// @param owner  whose shapes they are, for names: "palm"
/// @param taken  paths that are not to be written; grows by those that are
/// @returns the files to write
[[nodiscard]] WrittenFiles give_stl_files(std::vector<ShapeSpec>& shapes, const std::string& out,
                                          const std::string& owner, std::set<std::string>& taken);

/// Adds where the meshes of some shapes stand, as normal absolute paths.
/// @param folder  that names are relative to
void add_mesh_paths(const std::vector<ShapeSpec>& shapes, const std::string& folder,
                    std::set<std::string>& paths);

}  // namespace thenar
