#pragma once

/// The point of a wrench set nearest to the origin.

#include "grasp/quality/hull_support.h"

namespace thenar::internal {

/// Nearest point and what it proves of the distance.
struct [[nodiscard]] MinNorm {
  Wrench x;      // a point of the set, rounding aside: the distance is at most |x|
  Wrench away;   // unit direction with the least support found
  double reach;  // h(away): where negative, the distance is at least -reach
  int supports;  // asked for
};

/// min |x| over the set, by Wolfe's method on support points, until |x| + h(-x/|x|) <= gap or x is
/// 0 to rounding. The gap cannot be met where the origin lies inside: x is then about 0.
/// Source: [Wolfe1976].
MinNorm min_norm(const Support& support, double gap);

}  // namespace thenar::internal
