#pragma once

/// Reduction of many contact points to a few.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// The points to keep.
struct ReducedPoints {
  std::vector<int> kept;  // columns, around the hull
  double loss;            // no point is farther from the hull of the kept ones, in the plane [m]
};

/// Points of a plane whose convex hull is nearly that of all.
///
/// Points all nearer to each other than `merge` are one, the first; if all lie within merge / 2 of
/// the line through the two farthest apart, these two; else the corners of the convex hull, less
/// those, smallest loss first, that leave the hull within `merge / 10`, and as many more as
/// `most` allows no longer. A force at a dropped point can be had at the kept ones but for a torque
/// of at most loss times force.
/// @param points  columns, at least one [m] (2, points);  @param most  at least 3
/// Source: [Andrew1979] for the hull.
[[nodiscard]] ReducedPoints reduce_points(const Eigen::Matrix2Xd& points, double merge, int most);

}  // namespace thenar
