#pragma once

/// Contacts of spheres, capsules and tapered capsules.

#include <vector>

#include "geometry/manifold/part_pair.h"

namespace thenar::internal {

/// Finds the contact points of two hulls of two balls.
///
/// Every point is the contact of one ball of A with one of B. The smallest gap over both axes, both
/// parameters in [0, 1], is that of
///   g(s, t) = |P(s) - Q(t)| - r_A(s) - r_B(t),
/// convex while the axes do not intersect. The balls at the four ends also count if their nearest
/// ball of the other hull is within its axis, so that capsules side by side touch in two points;
/// the minimum is left out if it is nearer than the nearest end by less than 0.1 um.
///
/// Limitations: if the axes cross, the depth is that of the crossing balls along the common
/// perpendicular; it keeps its side only while `memory` stores it.
double round_on_round(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                      double margin, PartMemory& memory, std::vector<ManifoldPoint>& points);

/// Finds the contact points of a hull of two balls, A, on a convex solid B with a distance d in
/// closed form.
///
/// Every point is the contact of one ball of A: its gap is  d(P(t)) - r(t), convex in t. Points are
/// the minimum, by tangents from both sides, and the ends of the part of the axis that is above the
/// same face of B: above a box between its sides, above a cylinder between its caps or within its
/// rim. The minimum is left out if it is nearer than both ends by less than 0.1 um.
///
/// Limitations: an axis that pierces a thin B is pushed out of the face that is nearest to its
/// deepest ball, which may be the far one.
double round_on_convex(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                       double margin, PartMemory& memory, std::vector<ManifoldPoint>& points);

}  // namespace thenar::internal
