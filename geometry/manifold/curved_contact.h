#pragma once

/// Contacts of cylinders on the faces of boxes, and of ellipsoids.

#include <optional>
#include <vector>

#include "geometry/manifold/part_pair.h"

namespace thenar::internal {

/// Finds the points of a cylinder A on a face of a box B: six points around each rim, 60 degrees
/// apart, where they are nearer than the margin; six of an upright cylinder, two of a lying one,
/// one of a tilted one. They are fixed to A while it leans by less than 1e-4 rad; from 1e-3 rad on
/// one of them is the lowest point of the rim; in between it may lag behind that point by an angle
/// between 30 degrees and zero, so that it never jumps. The error of the gap is at most 3e-5 radii.
///
/// @return a lower bound of the distance [m]; nothing, without added points, if another part of A
/// is nearer to B than those points, one beside the face
std::optional<double> cylinder_on_face(const CollisionPart& a, const CollisionPart& b,
                                       const Pose<double>& X_BA, double margin, PartMemory& memory,
                                       std::vector<ManifoldPoint>& points);

/// Finds the point of an ellipsoid A deepest in, or nearest to, a convex solid B whose distance d
/// is in closed form: the minimum of d over A, both convex, where A's outward normal is opposite to
/// the gradient n of d:
///   x = -E^2 n / |E n|  in A's frame,   E its semi-axes.
/// Newton's method on  n -> grad d(x(n)) - n  with finite-difference slopes, damped while the
/// residual grows. The depth is the same with A and B exchanged.
///
/// If an edge of a box is inside A, the deepest point x is equally near to two faces and has no
/// gradient; the result is then the point of the box's edges that is deepest in A.
///
/// @return a lower bound of the distance [m]; nothing, without added points, if it does not
/// converge to 1e-9, as where the rim of a cylinder is inside A
std::optional<double> ellipsoid_on_convex(const CollisionPart& a, const CollisionPart& b,
                                          const Pose<double>& X_BA, double margin,
                                          PartMemory& memory, std::vector<ManifoldPoint>& points);

}  // namespace thenar::internal
