#pragma once

/// Faces of the wrenches of one contact, for Minkowski sums over contacts [unit forces].

#include <array>
#include <optional>
#include <vector>

#include "grasp/contact/wrench_set.h"

namespace thenar::internal {

/// A face of dimension 1 to 3 of the body of one contact; the whole body counts as a face, too.
struct ContactFace {
  int dimension;
  std::array<WrenchCoordinates, 3> span;  // vectors along it, as many as its dimension
  double size;  // its measure over that of the parallelotope of `span` [1]
  std::array<WrenchCoordinates, 2> inward;  // vectors from it along the neighbouring faces
  int inwards;  // their number: u is an outer normal if u'inward < 0 for each
};

/// Convex hull of points and 0, of dimension 3 at most.
struct ContactBody {
  std::vector<WrenchCoordinates> points;  // its corners, and perhaps other points of it
  std::vector<ContactFace> faces;         // of dimension 1 and higher
};

/// Faces of a contact. @return nothing if the points span more than three dimensions or exceed 200
[[nodiscard]] std::optional<ContactBody> contact_body(const std::vector<WrenchCoordinates>& points);

}  // namespace thenar::internal
