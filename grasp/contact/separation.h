#pragma once

/// How far two solids are apart.

#include <Eigen/Core>

#include "base/shapes/solid.h"
#include "base/spatial.h"

namespace thenar {

/// The nearest pair of points of two solids, in world.
struct Separation {
  double distance;         // negative: deepest point of A in B found [m]
  double error;            // the distance is true within this [m]
  Eigen::Vector3d on_a;    // [m] (3)
  Eigen::Vector3d on_b;    // [m] (3)
  Eigen::Vector3d normal;  // unit, outward of B at on_b (3)
};

/// Finds the point of A deepest in, or nearest to, B by branch and bound: the distance of B
/// changes by no more than the way gone, so a triangle whose centre is farther than the best
/// point by more than its radius cannot hold a better one.
///
/// A is searched by its touch surface, B asked by its shape. Where A encloses B without touching it
/// the distance is positive: hands do not swallow objects.
///
/// @param tolerance  error allowed [m]
/// @param cutoff     distances beyond this need not be exact: the result is then a lower bound [m]
[[nodiscard]] Separation separation(const Solid& a, const Pose<double>& X_WA, const Solid& b,
                                    const Pose<double>& X_WB, double tolerance = 5e-5,
                                    double cutoff = 1e30);

}  // namespace thenar
