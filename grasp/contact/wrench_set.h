#pragma once

/// The wrenches that contacts can make, with their true friction cones.

#include <vector>

#include <Eigen/Core>

#include "grasp/contact/contact.h"

namespace thenar {

using ScaledWrench = Eigen::Matrix<double, 6, 1>;  // force [N], then torque / scale [N] (6)

/// What one contact can make at unit normal force: an ellipsoid { c + A z : |z| <= 1 }, a disc for
/// a hard point with friction, a point without, three-dimensional for a soft finger.
/// Its support function is  h(u) = u' c + |A' u|.
struct WrenchCap {
  ScaledWrench c;                                       // frictionless unit wrench (6)
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 3> A;  // semi-axes (6, 0..3)
  int contact = -1;  // caps of one number >= 0 share the limit of a patch; -1: a patch of its own
};

/// All contacts of a grasp.
struct WrenchSet {
  std::vector<WrenchCap> caps;  // one a point of contact, or several of one number
};

/// How contact forces are limited together.
enum class ForceNorm {
  kL1,   // the sum of normal forces is at most 1: the convex hull of the caps
  kLinf  // the normal force of each patch, summed over its points, is at most 1: the Minkowski sum
         // over patches of conv({0} + caps)
};

/// Caps of contacts about a centre, torques divided by `torque_scale`; contacts of one region
/// (contact_regions()) share a number. How finely a patch is cut into points changes no set: the
/// cap of a point between others of one normal and friction is a mixture of theirs.
///   c = (n, (p - centre) x n / scale),  semi-axes mu (t, (p - centre) x t / scale) for tangents
///   t = t1, t2, and (0, torsion n / scale).
/// @throws InputError unless normals are unit, coefficients not negative, scale positive, all
/// finite. Source: [Ferrari1992] for the sets, [Howe1996] for the ellipsoid of soft fingers.
[[nodiscard]] WrenchSet wrench_set(const std::vector<Contact>& contacts,
                                   const Eigen::Vector3d& centre, double torque_scale);

/// Support of the whole set in a direction:  max over L1 caps; for Linf the sum over contacts of
/// the best of their caps, where positive.
[[nodiscard]] double support(const WrenchSet& set, const ScaledWrench& u, ForceNorm limit);

namespace internal {
/// Singular values, widths and distances below this part of the largest count as zero [1].
inline constexpr double kFlat = 1e-10;
}  // namespace internal

}  // namespace thenar
