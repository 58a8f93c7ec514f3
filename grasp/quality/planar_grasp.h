#pragma once

/// Quality of planar grasps: forces along x and y, torques about z.

#include <vector>

#include "grasp/quality/epsilon.h"

namespace thenar {

/// Computes the wrenches of contacts in the plane z = 0: the ends n +- mu t of each friction cone,
/// as points (f_x, f_y, 0, 0, 0, torque / scale) [1]; contacts of one region share a number.
/// @throws InputError as wrench_set(), and if a position or normal is off the plane or a contact
///         has torsion
[[nodiscard]] WrenchSet planar_wrench_set(const std::vector<Contact>& contacts,
                                          const Eigen::Vector3d& centre, double torque_scale);

/// Computes the signed epsilon in the three-dimensional space of planar wrenches, with rank up to 3
/// and directions that are zero off the plane. It is exact: the bounds differ by rounding only,
/// 1e-12 of the largest wrench.
///
/// No direction has a support below epsilon, and the normal of the nearest facet attains it. Hence
/// epsilon is the minimum support over any list of directions that contains all facet normals:
///   L1:   normals to every three points of the set;
///   Linf: normals to every two edges of the contacts' hulls with 0, as a facet of a sum is spanned
///         by edges of its summands [Schneider2014].
/// If the minimum is not positive, or the set is flat: minus the distance, or 0, as epsilon().
/// @param set  points without axes, from planar_wrench_set(); at most kMaxPlanarPoints
/// @throws InputError if a wrench is off the plane, not finite or has axes, or there are too many
[[nodiscard]] Epsilon planar_epsilon(const WrenchSet& set, ForceNorm limit);

inline constexpr int kMaxPlanarPoints =
    300;  // maximum number of points, for a few seconds of computation

}  // namespace thenar
