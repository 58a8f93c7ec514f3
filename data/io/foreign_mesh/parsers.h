#pragma once

#include <string>

#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// The triangles of a glTF, GLB or Collada, in single precision, placed by the file's
/// own scene graph. To be called once in a program, which opens nothing from then on.
/// @throws DataError if the file is none of these, or broken.
[[nodiscard]] TriangleSoup read_assimp_mesh(const std::string& path);

/// The triangles of a VRML 1.0, VRML 2.0 or Inventor file, in single precision, placed by its own
/// transforms; spheres, cones and cylinders tessellated. Where it holds nothing but whole spheres,
/// boxes and cylinders that place_primitive() places, they are its exact shapes as well, with sizes
/// and transforms as they were written (rotations in single precision). To be called once in a
/// program, which opens nothing from then on.
/// @throws DataError if the file is none of these, or broken; or if thenar was built without Coin.
[[nodiscard]] TriangleSoup read_inventor_mesh(const std::string& path);

/// Refuses a Collada on which assimp would never come to an end or read beyond its numbers: no well
/// formed XML, lists of whole numbers (<p>, <vcount>..) that hold anything else, <accessor>s that
/// reach beyond their <float_array>; nor one that names other files, or whose nodes stand in
/// themselves or for more than 100,000.
/// @param path  names the file in messages
/// @throws DataError at the first line that is wrong.
void check_collada(const std::string& text, const std::string& path);

// Which files parsers of others may open.

/// From now on this process opens no file, but by read_one(): parsers, and the libraries below
/// them, find none of the textures, fonts and files that a mesh may name.
void open_nothing();

/// The bytes of a file of at most as many as a mesh may have, also after open_nothing().
/// @throws DataError
[[nodiscard]] std::string read_one(const std::string& path);

/// Whether `file` is a regular file in the folder of `path` or below it, wherever links lead.
[[nodiscard]] bool is_file_beside(const std::string& path, const std::string& file);

}  // namespace thenar
