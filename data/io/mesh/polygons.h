#pragma once

/// Surfaces of polygons, as OBJ, PLY and OFF hold them, cut into triangles.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// Vertices and the faces between them. Faces of fewer than three corners are points and lines.
struct Polygons {
  std::vector<Eigen::Vector3d> vertices;  // [unit of the file]
  std::vector<int> corners;               // of all faces, one after another: numbers of vertices
  std::vector<int> sizes;                 // how many corners each face has
  std::vector<int> lines;                 // where each face stands, from 1
};

/// The triangles of all faces. A quadrangle or polygon that is not convex is cut by its ears.
/// @param path  names the file in messages
/// @throws DataError at the line of a face with a corner that does not exist, or if there are more
/// than kMaxTriangles, or faces that are neither convex nor of a reasonable number of corners.
[[nodiscard]] TriangleSoup triangulate_polygons(const Polygons& polygons, const std::string& path);

/// The vertices and faces of a Wavefront OBJ. Materials, textures, normals, lines and all else are
/// passed over: no other file is opened, whatever `mtllib` names.
/// @param path  names the file in messages
/// @throws DataError at the line of a vertex or face that is none.
[[nodiscard]] Polygons parse_obj(const std::string& text, const std::string& path);

/// The vertices and faces of an OFF in text; colours and normals are left out.
/// @param path  names the file in messages
/// @throws DataError at the line that is no OFF, that promises more than the file can hold, or
/// whose face has corners that do not exist.
[[nodiscard]] Polygons parse_off(const std::string& text, const std::string& path);

/// The vertices and faces (or strips of triangles) of a PLY, in text or in bytes of either order;
/// other elements and properties are passed over.
/// @param path  names the file in messages
/// @throws DataError at the line of the header that is wrong or promises more than the file can
/// hold; at the line of text that is wrong; at line 1 if bytes are missing.
[[nodiscard]] Polygons parse_ply(const std::string& text, const std::string& path);

}  // namespace thenar
