#pragma once

/// A surface as loose triangles, as mesh files hold it.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/shapes/triangle_mesh.h"

namespace thenar {

/// Three corners for each triangle [unit of the file].
struct TriangleSoup {
  std::vector<Eigen::Vector3d> corners;
};

/// The soup as a surface: corners at exactly the same place become one vertex, triangles of which
/// two corners are the same vertex (and so without an area) are left out.
/// @param scale  [m] per unit of the soup
/// @param path   names the file in messages
/// @throws DataError if no triangle is left, or a coordinate is not finite.
[[nodiscard]] TriangleMesh merge_corners(const TriangleSoup& soup, double scale,
                                         const std::string& path);

}  // namespace thenar
