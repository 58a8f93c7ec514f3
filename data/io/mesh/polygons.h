#pragma once

/// Polygons of OBJ, PLY and OFF files, and their triangulation.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/mesh/triangle_soup.h"

namespace thenar {

/// Vertices, and faces between them. Faces of fewer than three corners are points and lines.
struct Polygons {
  std::vector<Eigen::Vector3d> vertices;  // [unit of the file]
  std::vector<int> corners;               // vertex indices of all faces, one face after another
  std::vector<int> sizes;                 // number of corners of each face
  std::vector<int> lines;                 // line of each face in the file, from 1
};

/// Triangulates all faces; polygons that are not convex by ear clipping.
/// @param path  names the file in messages
/// @throws DataError at the line of a face with a corner that does not exist, or if there are more
/// than kMaxTriangles, or non-convex faces with too many corners.
[[nodiscard]] TriangleSoup triangulate_polygons(const Polygons& polygons, const std::string& path);

/// Reads vertices and faces of a Wavefront OBJ. Materials, textures, normals, lines and all other
/// entries are skipped; no other file is opened, whatever `mtllib` names.
/// @param path  names the file in messages
/// @throws DataError at the line of a malformed vertex or face.
[[nodiscard]] Polygons parse_obj(const std::string& text, const std::string& path);

/// Reads vertices and faces of an OFF in text; colours and normals are skipped.
/// @param path  names the file in messages
/// @throws DataError at the first line that is malformed, promises more than the file can hold, or
/// has corners that do not exist.
[[nodiscard]] Polygons parse_off(const std::string& text, const std::string& path);

/// Reads vertices and faces (or triangle strips) of a PLY, in text or in bytes of either order;
/// other elements and properties are skipped.
/// @param path  names the file in messages
/// @throws DataError at the line of the header that is wrong or promises more than the file can
/// hold; at the line of malformed text; at line 1 if bytes are missing.
[[nodiscard]] Polygons parse_ply(const std::string& text, const std::string& path);

}  // namespace thenar
