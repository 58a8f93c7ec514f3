#pragma once

/// Surfaces from mesh files.

#include <string>

#include "base/shapes/triangle_mesh.h"

namespace thenar {

enum class MeshFormat { kObj, kStl, kPly, kOff, kGltf, kCollada, kVrml, kInventor };

/// By the ending of its name, .wrl for VRML and .iv for Inventor.
/// @throws DataError for any other, listing those there are.
[[nodiscard]] MeshFormat mesh_format(const std::string& path);

/// Whether mesh_format() knows the ending.
[[nodiscard]] bool is_mesh_file(const std::string& path);

/// Reads OBJ, STL, PLY, OFF, glTF/GLB, Collada (in its unit; its up axis is not heeded, as in ROS)
/// and, where Coin was found, VRML 1.0 and 2.0 and Inventor.
/// Vertices at the same place are merged; polygons are cut into triangles; the transforms of
/// the file's own scene graph are applied.
/// @param scale  [m] per unit of the file
/// @throws DataError if the file cannot be read, its kind is unknown, it holds no triangle, or a
/// coordinate is not finite.
[[nodiscard]] TriangleMesh read_mesh(const std::string& path, double scale = 1);

/// An OBJ, STL (binary), PLY or OFF, by the ending of `path`, which is not touched.
/// @throws InputError for another ending, and for a mesh without triangles or with broken ones.
[[nodiscard]] std::string mesh_bytes(const std::string& path, const TriangleMesh& mesh);

/// Writes these bytes.
void write_mesh(const std::string& path, const TriangleMesh& mesh);

}  // namespace thenar
