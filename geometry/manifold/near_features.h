#pragma once

/// Corners, edges and faces of two polyhedra that are near each other.

#include <array>
#include <vector>

#include "base/spatial.h"
#include "geometry/manifold/polyhedron.h"

namespace thenar {

/// What two polyhedra A and B may touch with, good while they move by less than `reach`.
struct NearFeatures {
  std::vector<int> corners_a, corners_b;  // of Polyhedron::corners
  std::vector<std::array<int, 2>> edges;  // of Polyhedron::edges (A, B)
  std::vector<int> faces_b;               // of Polyhedron::faces
};

}  // namespace thenar
