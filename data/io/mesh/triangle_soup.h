#pragma once

/// Surfaces as loose triangles, as mesh files state them.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "geometry/shape_spec.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// Triangles by their corners, three each.
struct TriangleSoup {
  std::vector<Eigen::Vector3d> corners;  // [unit of the file]
  // The file's own vertex at each corner; empty if corners share none, as in STL.
  std::vector<int> vertices;
  // If all triangles belong to spheres, boxes and cylinders, these [unit of the file].
  std::vector<ShapeSpec> exact = {};
};

/// Largest number of exact shapes of a file; beyond it only triangles are used.
constexpr std::size_t kMaxExact = 64;

/// Largest number of triangles of a file; no hand or object needs more.
constexpr std::size_t kMaxTriangles = 2'000'000;

/// Welds the soup to a surface: corners at exactly the same place become one vertex;
/// triangles with two equal corners (and so without area) are left out.
///
/// Parts that only touch stay apart, like those of convex decompositions: if consecutive triangles
/// of the file close a surface, its vertices are its own, unless merging everything leaves fewer
/// open edges. Corners on open edges that lie within 1e-6 of the box from each other are merged if
/// that closes edges and puts no third triangle on any, because files round their last digits.
/// Nothing else is moved; repair_to_solid() repairs the remaining openings, and reports them.
/// @param scale  [m] per unit of the soup
/// @param path   names the file in messages
/// @throws DataError if no triangle is left, or a coordinate is not finite or beyond 1e6 m.
[[nodiscard]] TriangleMesh weld_vertices(const TriangleSoup& soup, double scale,
                                         const std::string& path);

/// Reads an STL file, binary or text. Text may be in any case and on any lines, with several
/// solids; binary data may be followed by other bytes, and their header may begin with "solid".
/// @param path  names the file in messages
/// @throws DataError if it is neither, is cut off, or a number is malformed.
[[nodiscard]] TriangleSoup parse_stl(const std::string& text, const std::string& path);

}  // namespace thenar
