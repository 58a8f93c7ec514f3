#pragma once

/// A surface as loose triangles, as mesh files hold it.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "geometry/shape_spec.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Three corners for each triangle.
struct TriangleSoup {
  std::vector<Eigen::Vector3d> corners;  // [unit of the file]
  // The file's own vertex at each corner; empty where corners share none, as in STL.
  std::vector<int> vertices;
  // Where all triangles stand for spheres, boxes and cylinders, these [unit of the file].
  std::vector<ShapeSpec> exact = {};
};

/// More exact shapes than these stay triangles.
constexpr std::size_t kMaxExact = 64;

/// A file of more triangles is refused: a hand or an object has no need of them.
constexpr std::size_t kMaxTriangles = 2'000'000;

/// The soup as a surface: corners at exactly the same place become one vertex, triangles of which
/// two corners are the same vertex (and so without an area) are left out.
///
/// Parts stay apart where they only touch, as those of convex decompositions do: where triangles
/// that follow each other in the file close a surface, its vertices are its own, unless merging all
/// leaves fewer edges open. Where edges are open, corners on them that lie within 1e-6 of the box
/// from each other become one, if that closes edges and puts no third triangle on any: files round
/// their last digits. Nothing else is moved: what is still open, repair_to_solid() mends, and says
/// so.
/// @param scale  [m] per unit of the soup
/// @param path   names the file in messages
/// @throws DataError if no triangle is left, or a coordinate is not finite or beyond 1e6 m.
[[nodiscard]] TriangleMesh weld_vertices(const TriangleSoup& soup, double scale,
                                         const std::string& path);

/// The triangles of an STL, in bytes or as text. Text may stand in any case and on any lines, and
/// hold several solids; bytes may be followed by others, and their heading begin with "solid".
/// @param path  names the file in messages
/// @throws DataError if it is neither, is cut off, or a number is none.
[[nodiscard]] TriangleSoup parse_stl(const std::string& text, const std::string& path);

}  // namespace thenar
