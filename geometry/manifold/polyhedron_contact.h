#pragma once

/// Contacts of bodies of triangles.

#include <vector>

#include "geometry/manifold/part_pair.h"

namespace thenar::internal {

/// Finds the contact points of two polyhedra in both directions: corners of A by their distance
/// from B's shape, corners of B by theirs from A's, and edges that cross. Each is a local contact:
///   a corner, if no edge leads from it more than 30 degrees down towards the other body;
///   two edges, if their common normal is between the normals of the faces at both, within 0.1,
///   and, if they are deeper than 0.2 mm, each has its point inside the other body.
/// Candidate features are found by trees of balls and kept while the motion allows (NearFeatures).
/// Edges are searched to a depth of 3 mm, corners to any depth; bodies that overlap without a local
/// contact have one point, their deepest corner. Thus every local minimum of the distance and every
/// corner of a shallow overlap is a point, and points move with the features.
///
/// Limitations: a corner that is deeper in B than B's nearest other face is pushed out of the other
/// face. Two parallel edges that cross no face have only their corners. Beyond a depth of 3 mm the
/// edges that count depend on earlier searches. A body deep inside another is slow, as all its
/// corners are. Curved bodies that are not polyhedra (superellipsoids; cylinders and ellipsoids on
/// meshes; cylinders on each other and beside a box's face) are tessellated, so that their gaps
/// have errors up to 0.02 mm, or 1.5e-4 of their size if that is more.
double polyhedron_on_polyhedron(const CollisionPart& a, const CollisionPart& b,
                                const Pose<double>& X_BA, double margin, PartMemory& memory,
                                std::vector<ManifoldPoint>& points);

/// Finds the contact points of a hull of two balls, A, on a polyhedron: the balls at its ends on
/// faces and edges, and its axis on edges and corners, each where the vector to the ball's centre
/// is a normal of the feature: all local minima of the distance. A ball in a groove touches both
/// sides.
///
/// Limitations: once the axis is inside, only the end balls count, with the surface nearest to each
/// centre; for an axis that pierces B also the deepest of five balls in between.
double round_on_polyhedron(const CollisionPart& a, const CollisionPart& b, const Pose<double>& X_BA,
                           double margin, PartMemory& memory, std::vector<ManifoldPoint>& points);

}  // namespace thenar::internal
