#pragma once

/// Faces of the convex body of one contact's wrenches, for Minkowski sums over contacts [unit
/// forces].

#include <array>
#include <optional>
#include <vector>

#include "grasp/contact/wrench_set.h"

namespace thenar::internal {

/// A face of dimension 1 to 3 of the body of one contact; the whole body is also a face.
struct ContactFace {
  int dimension = 0;
  std::array<WrenchCoordinates, 3> span;    // vectors that span it, as many as its dimension
  double size = 0;                          // measure over that of the parallelotope of `span` [1]
  std::array<WrenchCoordinates, 2> inward;  // vectors from it along the neighbouring faces
  int inward_count = 0;  // number of vectors; u is an outer normal if u'inward < 0 for each
};

/// Convex hull of points and 0, of dimension at most 3.
struct ContactBody {
  std::vector<WrenchCoordinates> points;  // corners, and possibly other points
  std::vector<ContactFace> faces;         // faces of dimension 1 and higher
};

/// Computes the faces of a contact. @return nothing if there are more than 200 points, or they span
/// more than three dimensions
[[nodiscard]] std::optional<ContactBody> contact_body(const std::vector<WrenchCoordinates>& points);

}  // namespace thenar::internal
