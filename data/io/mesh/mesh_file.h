#pragma once

/// Surfaces from mesh files.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geometry/shape_spec.h"
#include "geometry/triangle_mesh.h"

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

/// What a mesh file holds [m].
struct MeshContent {
  TriangleMesh mesh;  // as read_mesh() gives it
  // Where VRML or Inventor holds nothing but spheres, boxes and cylinders that its transforms leave
  // what they are: these, with sizes and places to rounding. Else empty.
  std::vector<ShapeSpec> exact;
};

/// As read_mesh().
[[nodiscard]] MeshContent read_mesh_content(const std::string& path, double scale = 1);

/// Time that is left to those meshes of one file which other programs' parsers read. Each megabyte
/// brings 0.2 s of the processor along; the clock runs while one takes more than half a second.
struct MeshTime {
  double processor = 10;  // [s]
  double clock = 12;      // [s]
};

/// The meshes that one robot or world names. Each file is read once, also where that fails, and
/// together they have a limit of time and of triangles.
class MeshReader {
 public:
  /// As read_mesh().
  /// @throws DataError also if meshes before have taken all time, or with this one there are more
  /// than kMaxTogether triangles.
  [[nodiscard]] const MeshContent& content(const std::string& path, double scale = 1);

  /// Its triangles.
  [[nodiscard]] TriangleMesh read(const std::string& path, double scale = 1) {
    return content(path, scale).mesh;
  }

  static constexpr Eigen::Index kMaxTogether = 4'000'000;  // triangles

 private:
  MeshTime left_;
  Eigen::Index triangles_ = 0;                 // of all that were given
  using Key = std::pair<std::string, double>;  // file and scale
  std::map<Key, MeshContent> contents_;
  std::map<Key, DataError> failures_;
};

/// An OBJ, STL (binary), PLY or OFF, by the ending of `path`, which is not touched.
/// @throws InputError for another ending, and for a mesh without triangles or with broken ones.
[[nodiscard]] std::string mesh_bytes(const std::string& path, const TriangleMesh& mesh);

/// Writes these bytes.
void write_mesh(const std::string& path, const TriangleMesh& mesh);

}  // namespace thenar
