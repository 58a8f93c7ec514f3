#pragma once

/// Contacts of two boxes.

#include <vector>

#include "geometry/manifold/part_pair.h"

namespace thenar::internal {

/// Points of two boxes.
///
/// Of the 15 directions n that may separate them (faces of each, edges across) the one with the
/// largest  min over A of n.x - max over B of n.x  counts; while they overlap, the last one as
/// long as it is not worse by more than 2 % and 10 um. Where they are apart and the nearest
/// points are not those of that direction, n comes from convex_distance().
///
/// If a face of each lies across n (one within 11 degrees), the other's face, cut by planes through
/// the sides of the first one, gives the points: corners of either and crossings of edges. All with
/// gaps  (on_a - on_b) . n.  Which of the two cuts changes only if the other is better aligned by
/// 0.57 degrees (0.01 rad), and hardly matters: features are named by the edges and corners that
/// meet, alike both ways. Otherwise edges cross in one point.
///
/// Fails: two edges that are parallel and lie diagonally have one point, not two. At 11 degrees the
/// points beside a crossing of edges appear at once, with gaps of at least a fifth of their
/// distance from it.
/// Source: [Gottschalk1996] for the directions, [Sutherland1974] for the cuts.
double box_on_box(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                  double margin, PartMemory& memory, std::vector<ManifoldPoint>& points);

}  // namespace thenar::internal
