#pragma once

/// Grasps in a plane: forces along x and y, torques about z.

#include <vector>

#include "grasp/quality/epsilon.h"

namespace thenar {

/// Wrenches of contacts in the plane z = 0: the ends n +- mu t of each friction cone, as points
/// (f_x, f_y, 0, 0, 0, torque / scale); contacts of one region share a number.
/// @throws InputError as wrench_set(), and if a place or normal is off the plane or a contact has
/// torsion
[[nodiscard]] WrenchSet planar_wrench_set(const std::vector<Contact>& contacts,
                                          const Eigen::Vector3d& centre, double torque_scale);

/// Signed epsilon in the three-dimensional space of planar wrenches; rank of 3, and directions with
/// zeros off the plane. Exact: both bounds are the value with its rounding, 1e-12 of the largest
/// wrench.
///
/// h(u) of a direction is never below epsilon, and equals it at the normal of the nearest facet, so
/// epsilon is the least h over any list of directions that has all facets' normals:
///   L1:   normals to every three points of the set;
///   Linf: normals to every two edges of the contacts' hulls with 0, as a facet of a sum is spanned
///         by edges of its summands [Schneider2014].
/// Where that is not positive, or the set is flat: minus the distance, or 0, as epsilon().
/// @param set  points without axes, as planar_wrench_set() makes them; at most kMaxPlanarPoints
/// @throws InputError if a wrench is off the plane, not finite or has axes, or there are too many
[[nodiscard]] Epsilon planar_epsilon(const WrenchSet& set, ForceNorm limit);

inline constexpr int kMaxPlanarPoints = 300;  // some seconds

}  // namespace thenar
