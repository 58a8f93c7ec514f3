#pragma once

#include <string>

#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// Reads the triangles of a glTF, GLB or Collada file, in single precision, placed by its scene
/// graph. Call it once in a process, which opens no file from then on.
/// @throws DataError if the file is of another kind, or broken.
[[nodiscard]] TriangleSoup read_assimp_mesh(const std::string& path);

/// Reads the triangles of a VRML 1.0, VRML 2.0 or Inventor file, in single precision, placed by its
/// transforms; spheres, cones and cylinders are tessellated. If it consists of whole spheres, boxes
/// and cylinders that place_primitive() can place, these are its exact shapes as well, with sizes
/// and transforms as written (rotations in single precision). Call it once in a process, which
/// opens no file from then on.
/// @throws DataError if the file is of another kind, or broken, or if thenar was built without
///         Coin.
[[nodiscard]] TriangleSoup read_inventor_mesh(const std::string& path);

/// Checks a Collada text for faults on which assimp would not terminate or read out of bounds:
/// malformed XML, lists of whole numbers (<p>, <vcount>..) with other content, <accessor>s that
/// reach beyond their <float_array>; and a text that names other files, or whose nodes contain
/// themselves or expand to more than 100,000 nodes.
/// @param path  names the file in messages
/// @throws DataError at the first line that is wrong.
void check_collada(const std::string& text, const std::string& path);

/// Prevents this process from opening files except by read_permitted_file(), so that parsers and
/// their libraries cannot open textures, fonts and files that a mesh refers to.
void forbid_opening_files();

/// Reads a file within the size limit of meshes [bytes], also after forbid_opening_files().
/// @throws DataError
[[nodiscard]] std::string read_permitted_file(const std::string& path);

/// Returns true if `file` is a regular file in the folder of `path` or below it, with links
/// resolved.
[[nodiscard]] bool is_file_beside(const std::string& path, const std::string& file);

}  // namespace thenar
