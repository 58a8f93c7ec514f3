#pragma once

/// Convex hulls of a few hundred points in the plane or in space.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// One facet:  normal' x <= offset holds for every point.
struct HullFacet {
  Eigen::VectorXd normal;  // outward, unit length                                          (d)
  double offset;           // of the plane, in the unit of the points
  std::vector<int> ring;   // rows of its corners, in order; d = 3: counterclockwise from outside
};

/// Check of a hull, from points, planes and rings alone. Lengths in the unit of the points.
struct HullCheck {
  double outside = 0;   // farthest that a point lies outside a plane, or a corner inside its own
  bool closed = false;  // every edge is run through once each way; d = 3: and V - E + F = 2
  double volume = 0;    // by the divergence theorem; d = 2: area
  double volume_error = 0;  // largest less least of the volumes by x, by y and by z alone
};

struct ConvexHull {
  std::vector<HullFacet> facets;  // coplanar ones merged; empty on failure
  std::string message;            // why there is no hull; empty: there is one
  HullCheck check;
};

/// Hull of points that span their space, by Quickhull, without joggling.
///
/// Rounding is handled by merging facets: a facet plane may lie 1e-14 of the size of the set off
/// its points. Sets that are flat to that degree fail: reduce them to their affine hull first. The
/// result is checked: a hull that a point leaves by more than 1e-10 of the extent is a failure.
/// Merged facets may share a corner that belongs to none of their rings; `check.closed` then
/// says that the surface has gaps, though all planes hold.
///
/// @param points  one a row   k x d, d = 2 or 3
/// @throws InputError if d is not 2 or 3, there are fewer than d + 1 points, or one is not finite.
/// Source: [Barber1996].
[[nodiscard]] ConvexHull convex_hull(const Eigen::Ref<const Eigen::MatrixXd>& points);

}  // namespace thenar
