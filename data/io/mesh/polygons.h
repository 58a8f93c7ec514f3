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
/// than kMostTriangles, or faces that are neither convex nor of a reasonable number of corners.
[[nodiscard]] TriangleSoup cut_polygons(const Polygons& polygons, const std::string& path);

}  // namespace thenar
