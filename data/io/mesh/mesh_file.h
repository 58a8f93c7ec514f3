#pragma once

/// Reads and writes surface meshes in files.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/provenance.h"
#include "geometry/shape_spec.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Format of a mesh file.
enum class MeshFormat { kObj, kStl, kPly, kOff, kGltf, kCollada, kVrml, kInventor };

/// Returns the format by the ending of the file name, .wrl for VRML and .iv for Inventor.
/// @throws DataError for an unknown ending, listing the known ones.
[[nodiscard]] MeshFormat mesh_format(const std::string& path);

/// Returns a name with letters that all file systems and URLs accept; others become underscores.
[[nodiscard]] std::string plain_file_name(std::string name);

/// Returns whether mesh_format() knows the ending.
[[nodiscard]] bool is_mesh_file(const std::string& path);

/// Reads OBJ, STL, PLY, OFF, glTF/GLB, Collada (in its unit; its up axis is ignored, as in ROS)
/// and, if thenar was built with Coin, VRML 1.0, VRML 2.0 and Inventor. Vertices at the same place
/// are merged, polygons triangulated, and the transforms of the file's scene graph applied.
/// @param scale  [m] per unit of the file
/// @throws DataError if the file cannot be read, its format is unknown, it has no triangle, or a
/// coordinate is not finite.
[[nodiscard]] TriangleMesh read_mesh(const std::string& path, double scale = 1);

/// Content of a mesh file [m].
struct MeshContent {
  TriangleMesh mesh;  // result of read_mesh()
  // Exact shapes of a VRML or Inventor file that consists of spheres, boxes and cylinders whose
  // transforms preserve them, with sizes and poses to rounding; otherwise empty.
  std::vector<ShapeSpec> exact;
};

/// Reads mesh and exact shapes, as read_mesh().
[[nodiscard]] MeshContent read_mesh_content(const std::string& path, double scale = 1);

/// Time left for those meshes of one file that third-party parsers read. Each megabyte adds 0.2 s
/// of processor time; the clock counts only readers that take more than half a second.
struct MeshTime {
  double processor = 10;  // [s]
  double clock = 12;      // [s]
};

/// Reads the meshes that one robot or world names. Each file is read once, even if that fails, and
/// all files together have a limit of time and of triangles.
class MeshReader {
 public:
  /// Returns the content of a file, as read_mesh().
  /// @throws DataError also if earlier meshes used up the time, or if there are more than
  /// kMaxTogether triangles with this one.
  [[nodiscard]] const MeshContent& content(const std::string& path, double scale = 1);

  /// Returns the triangles of a file alone.
  [[nodiscard]] TriangleMesh read(const std::string& path, double scale = 1) {
    return content(path, scale).mesh;
  }

  /// Returns the digests of all requested files that exist, also of those that could not be read.
  [[nodiscard]] FileDigests files() const;

  static constexpr Eigen::Index kMaxTogether = 4'000'000;  // triangles

 private:
  MeshTime left_;
  Eigen::Index triangles_ = 0;                 // triangles in all returned meshes
  using Key = std::pair<std::string, double>;  // file and scale
  std::map<Key, MeshContent> contents_;
  std::map<Key, DataError> failures_;
};

/// Returns the bytes of an OBJ, STL (binary), PLY or OFF file, by the ending of `path`, which is
/// not written.
/// @throws InputError for another ending, and for a mesh without triangles or with invalid ones.
[[nodiscard]] std::string mesh_bytes(const std::string& path, const TriangleMesh& mesh);

/// Writes mesh_bytes() to the file.
void write_mesh(const std::string& path, const TriangleMesh& mesh);

}  // namespace thenar
