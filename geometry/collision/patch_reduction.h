#pragma once

/// Reduction of contact points to a few.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Points that are kept, and the error of the reduction.
struct ReducedPoints {
  std::vector<int> kept;  // columns of the kept points, around the hull
  double loss;  // maximum distance of a point from the hull of the kept ones, in the plane [m]
};

/// Selects points of a plane whose convex hull is nearly that of all.
///
/// If all points are nearer to each other than `merge`, the first is kept; if all lie within merge
/// / 2 of the line through the two farthest apart, these two; otherwise the corners of the convex
/// hull, without those, smallest loss first, that leave the hull within `merge / 10`, and without
/// further ones while there are more than `max_points`. The force at a dropped point can be
/// replaced by forces at the kept ones, up to a torque of at most loss times force.
/// @param points      columns, at least one [m] (2, points)
/// @param max_points  at least 3
/// Source: [Andrew1979] for the hull.
[[nodiscard]] ReducedPoints reduce_points(const Eigen::Matrix2Xd& points, double merge,
                                          int max_points);

}  // namespace thenar
