#pragma once

/// Faces of what one contact can make, for sums of many.

#include <array>
#include <optional>
#include <vector>

#include "grasp/quality/wrench_set.h"

namespace thenar::internal {

/// A face of dimension 1 to 3; the whole body counts as one, too.
struct ContactFace {
  int dimension;
  std::array<Wrench, 3> span;    // vectors along it, as many as its dimension
  double size;                   // its measure over that of the parallelotope of `span` [1]
  std::array<Wrench, 2> inward;  // from it along the faces next to it
  int inwards;                   // how many: a normal u is an outer one if u'inward < 0 for each
};

/// The hull of points and 0, of dimension 3 at most.
struct ContactBody {
  std::vector<Wrench> points;      // its corners, and maybe others of its points
  std::vector<ContactFace> faces;  // of dimension 1 and more
};

/// @return none if the points span more than three dimensions, or are more than 200
[[nodiscard]] std::optional<ContactBody> contact_body(const std::vector<Wrench>& points);

}  // namespace thenar::internal
