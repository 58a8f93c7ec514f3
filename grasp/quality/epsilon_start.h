#pragma once

/// Where the hull of a wrench set starts.

#include <array>

#include "grasp/quality/hull_support.h"

namespace thenar::internal {

/// Directions of the wrenches with 0.
struct Span {
  int rank;                           // how many of the basis span them: singular values above
                                      // 1e-10 of the largest
  Eigen::Matrix<double, 6, 6> basis;  // orthonormal columns, the spanning ones first
};
[[nodiscard]] Span span_of(const WrenchSet& set);

/// Seven support points that span all six dimensions.
struct FirstSimplex {
  std::array<Wrench, 7> points;
  bool found;    // false: the set is flatter than asked
  int supports;  // asked for
};

/// One after the other the point furthest across the affine hull of those before.
/// @param flat  least width, in parts of the size [1]
[[nodiscard]] FirstSimplex first_simplex(const Support& support, double flat);

}  // namespace thenar::internal
