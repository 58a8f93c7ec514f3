#pragma once

/// Meshes that third parties parse: glTF, Collada, VRML and Inventor.

#include <string>

#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// What the program that reads one such mesh may take.
struct MeshReaderLimits {
  int processor_seconds = 8;                  // [s]
  double clock_seconds = 12;                  // on a busy machine [s]
  std::size_t memory = std::size_t{1} << 30;  // beside its libraries [bytes]
};

/// The triangles of a glTF, GLB, Collada, VRML or Inventor file, with exact shapes, in single
/// precision, placed by its own scene graph. It is read by the program thenar-mesh-reader, under
/// MeshReaderLimits: what crashes, hangs or takes too much there is an error here. That program
/// opens this file only, and for glTF the buffers in the same folder or below.
/// @param left  of the time of all meshes that belong together; what this one takes is taken off
/// @throws DataError if the file nests too deeply, names other files to be put in its place, is
/// broken or too much; if no time is left; or if there is no such program.
[[nodiscard]] TriangleSoup read_foreign_mesh(const std::string& path, MeshFormat format,
                                             MeshTime& left);

/// The program: THENAR_MESH_READER, or thenar-mesh-reader beside the program that runs, where it
/// was built or installed, or on the PATH. Empty if there is none.
[[nodiscard]] std::string find_mesh_reader();

}  // namespace thenar
