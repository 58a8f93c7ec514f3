#pragma once

/// Convex hulls of a few hundred points in the plane or in space.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// One flat side:  normal' x <= offset holds for every point.
struct HullFacet {
  Eigen::VectorXd normal;  // outward, unit length                                          (d)
  double offset;           // of the plane, in the unit of the points
  std::vector<int> ring;   // rows of its corners, in order; d = 3: counterclockwise from outside
};

struct ConvexHull {
  std::vector<HullFacet> facets;  // coplanar ones merged; empty on failure
  std::string failure;            // why there is no hull; empty if there is one
};

/// Hull of points that span their space, by Quickhull, without joggling.
///
/// Rounding is met by merging facets: a facet plane may lie 1e-14 of the size of the set off its
/// points. Sets that are flat to that degree fail: bring their affine hull down first.
///
/// @param points  one a row   k x d, d = 2 or 3
/// @throws InputError if d is not 2 or 3, there are fewer than d + 1 points, or one is not finite.
/// Source: [Barber1996].
[[nodiscard]] ConvexHull convex_hull(const Eigen::Ref<const Eigen::MatrixXd>& points);

}  // namespace thenar
