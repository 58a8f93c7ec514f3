#pragma once

/// Contacts of bodies of triangles.

#include <vector>

#include "geometry/manifold/part_pair.h"

namespace thenar::internal {

/// Points of two polyhedra, both ways: corners of A by their distance from B's shape, corners of B
/// by theirs from A's, and edges that cross. Each is a local contact:
///   a corner, if no edge leads from it more than 30 degrees down towards the other body;
///   two edges, if their common normal lies between the normals of the faces at both, within 0.1,
///   and, where they are deeper than 0.2 mm, if each has its point in the other body.
/// Which features may count is found by trees of balls and kept while the motion allows
/// (NearFeatures). Edges are looked for to a depth of 3 mm, corners to any depth; bodies that
/// overlap without a local contact have one point, their deepest corner. So every local minimum of
/// the distance and every corner of a shallow overlap is a point, and points move with the
/// features.
///
/// Fails: a corner that is deeper in B than B's nearest other face is pushed out of the other face.
/// Two edges that are parallel and cross no face have their corners alone. Beyond 3 mm of depth
/// which edges count depends on what was looked for before. A body deep within another is slow, as
/// all its corners are. Bodies so curved that they are no polyhedra (superellipsoids; cylinders and
/// ellipsoids on meshes; cylinders on each other and beside a box's face) are tessellated, so their
/// gaps are true within 0.02 mm, or 1.5e-4 of their size if that is more.
double polyhedron_on_polyhedron(const CollisionPart& a, const CollisionPart& b,
                                const Pose<double>& X_BA, double margin, PartMemory& memory,
                                std::vector<ManifoldPoint>& points);

/// Points of a hull of two balls, A, on a polyhedron: the balls at its ends over faces and edges,
/// and its axis over edges and corners, each where the way to the ball's centre is a normal of the
/// feature: all local minima of the distance. A ball in a groove touches both sides.
///
/// Fails: once the axis is inside, the end balls alone count, by the surface nearest to each
/// centre; of an axis that pierces B also the deepest of five balls in between.
double round_on_polyhedron(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                           double margin, PartMemory& memory, std::vector<ManifoldPoint>& points);

}  // namespace thenar::internal
