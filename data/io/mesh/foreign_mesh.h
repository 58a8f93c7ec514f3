#pragma once

/// Meshes that third parties parse: glTF, Collada, VRML and Inventor.

#include <string>

#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// Limits of the program that reads one such mesh.
struct MeshReaderLimits {
  int processor_seconds = 8;                  // [s]
  double clock_seconds = 12;                  // allows for a busy machine [s]
  std::size_t memory = std::size_t{1} << 30;  // memory in addition to its libraries [bytes]
};

/// Reads the triangles of a glTF, GLB, Collada, VRML or Inventor file, with exact shapes, in single
/// precision, placed by its scene graph. The program thenar-mesh-reader parses it under
/// MeshReaderLimits, so that a parser that crashes, hangs or takes too much is an error here. It
/// opens this file only, and for glTF the buffers in the same folder or below.
/// @param left  time left for all meshes that belong together; reduced by the time of this one
/// @throws DataError if the file nests too deeply, includes other files, is broken or too large; if
/// no time is left; or if the program is missing.
[[nodiscard]] TriangleSoup read_foreign_mesh(const std::string& path, MeshFormat format,
                                             MeshTime& left);

/// Returns the path of the program: THENAR_MESH_READER, or thenar-mesh-reader beside the running
/// program, where it was built or installed, or on the PATH. Empty if it is missing.
[[nodiscard]] std::string find_mesh_reader();

}  // namespace thenar
