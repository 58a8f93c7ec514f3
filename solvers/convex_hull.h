#pragma once

/// Convex hulls of a few hundred points in the plane or in space.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// One facet:  normal' x <= offset holds for every point.
struct HullFacet {
  Eigen::VectorXd normal;  // outward, unit length                                          (d)
  double offset = 0;       // distance of the plane from the origin, in the unit of the points
  // Row indices of its corners, in order; d = 3: counterclockwise from outside
  std::vector<int> ring;
};

/// Verification of a hull from its points, planes and rings alone. Lengths in the unit of the
/// points.
struct HullCheck {
  // Largest distance of a point outside a plane, or of a corner inside its own plane
  double outside = 0;
  bool closed = false;  // every edge is traversed once in each direction; d = 3: and V - E + F = 2
  double volume = 0;    // volume by the divergence theorem; d = 2: area
  double volume_error = 0;  // range of the volumes computed from x, from y and from z alone
};

struct ConvexHull {
  std::vector<HullFacet> facets;  // facets, coplanar ones merged; empty on failure
  std::string message;            // reason why there is no hull; empty on success
  HullCheck check;
};

/// Computes the hull of points that span their space, by Quickhull without joggling.
///
/// Rounding errors are handled by merging facets: a facet plane may lie 1e-14 of the extent away
/// from its points. Sets that are flat to this degree fail and should be reduced to their affine
/// hull first. The result is verified: it is a failure if a point lies more than 1e-10 of the
/// extent outside. Merged facets may share a corner that belongs to none of their rings; then
/// `check.closed` is false although all planes are valid.
///
/// @param points  one point per row (k, d), d = 2 or 3
/// @throws InputError if d is not 2 or 3, there are fewer than d + 1 points, or one is not finite.
/// Source: [Barber1996].
[[nodiscard]] ConvexHull convex_hull(const Eigen::Ref<const Eigen::MatrixXd>& points);

}  // namespace thenar
