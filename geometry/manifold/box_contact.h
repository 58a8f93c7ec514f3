#pragma once

/// Contacts of two boxes.

#include <vector>

#include "geometry/manifold/part_pair.h"

namespace thenar::internal {

/// Finds the contact points of two boxes.
///
/// Of the 15 directions n that may separate them (faces of each, cross products of edges) the one
/// with the largest  min over A of n.x - max over B of n.x  is used; while they overlap, the last
/// one is kept as long as it is not worse by more than 2 % and 10 um. If they are apart and the
/// nearest points are not those of that direction, n comes from convex_distance().
///
/// If a face of each is perpendicular to n (one within 11 degrees), the other's face, clipped by
/// planes through the sides of the first one, gives the points: corners of either and crossings of
/// edges, all with gaps  (on_a - on_b) . n.  The face that clips is changed only if the other one
/// is better aligned by 0.57 degrees (0.01 rad), with little effect: features are named by the
/// edges and corners that meet, in the same way for both. Otherwise edges cross in one point.
///
/// Limitations: two parallel edges that meet diagonally have one point, not two. At 11 degrees the
/// points beside a crossing of edges appear suddenly, with gaps of at least 1/5 of their distance
/// from it.
/// Source: [Gottschalk1996] for the directions, [Sutherland1974] for the clipping.
double box_on_box(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                  double margin, PartMemory& memory, std::vector<ManifoldPoint>& points);

}  // namespace thenar::internal
