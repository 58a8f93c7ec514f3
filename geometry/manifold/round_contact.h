#pragma once

/// Contacts of spheres, capsules and tapered capsules.

#include <vector>

#include "geometry/manifold/part_pair.h"

namespace thenar::internal {

/// Points of two hulls of two balls.
///
/// Every point is the contact of one ball of A with one of B. The least gap over both axes, both in
/// [0, 1], is that of
///   g(s, t) = |P(s) - Q(t)| - r_A(s) - r_B(t),
/// convex while the axes do not meet. Also the balls at the four ends count whose nearest ball
/// of the other lies within its axis, so that capsules side by side touch in two points; the least
/// is left out where it is nearer than the nearest end by less than 0.1 um.
///
/// Fails: where axes cross, the depth is that of the crossing balls along the common perpendicular;
/// it keeps its side only while `memory` remembers it.
double round_on_round(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                      double margin, PartMemory& memory, std::vector<ManifoldPoint>& points);

/// Points of a hull of two balls, A, on a convex solid B with a distance d in closed form.
///
/// Every point is the contact of one ball of A: its gap is  d(P(t)) - r(t), convex in t. The least
/// counts, by tangents from both sides, and the ends of the part of the axis that stands over the
/// same face of B: over a box between its sides, over a cylinder between its caps or within its
/// rim. The least is left out where it is nearer than both ends by less than 0.1 um.
///
/// Fails: an axis that goes through a thin B is pushed out of the face that is nearest to its
/// deepest ball, which may be the far one.
double round_on_convex(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                       double margin, PartMemory& memory, std::vector<ManifoldPoint>& points);

}  // namespace thenar::internal
