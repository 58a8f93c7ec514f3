#pragma once

/// Wrench sets of contacts: the wrenches that they make within their true (round) friction cones.

#include <array>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "grasp/contact/contact.h"
#include "grasp/contact/scaled_wrench.h"

namespace thenar {

/// Wrenches of one contact at unit normal force: an ellipsoid { c + A z : |z| <= 1 }, a disc for
/// a hard point with friction, a point without, three-dimensional for a soft finger.
/// Its support function is  h(u) = u' c + |A' u|.
struct WrenchCap {
  ScaledWrench c;                                       // frictionless unit wrench
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 3> A;  // semi-axes, rows as WrenchCoordinates
                                                        // (6, 0..3)
  int contact = -1;  // caps with one number >= 0 share the limit of a patch; -1: their own patch
};

/// All contacts of a grasp.
struct WrenchSet {
  std::vector<WrenchCap> caps;  // one for each contact point, or several with one number
};

/// Norm that limits the contact forces together.
enum class ForceNorm {
  kL1,   // the sum of normal forces is at most 1: the convex hull of the caps
  kLinf  // the normal force of each patch, summed over its points, is at most 1: the Minkowski sum
         // over patches of conv({0} + caps)
};
inline constexpr std::array kForceNormNames{EnumName{ForceNorm::kL1, "l1"},
                                            EnumName{ForceNorm::kLinf, "linf"}};

/// Wrench caps of contacts about a centre, torques divided by `torque_scale`; contacts of one
/// region (contact_regions()) share a number. The number of points into which a patch is cut
/// changes no set: the cap of a point between others with the same normal and friction is a mixture
/// of theirs.
///   c = (n, (p - centre) x n / scale),  semi-axes mu (t, (p - centre) x t / scale) for tangents
///   t = t1, t2, and (0, torsion n / scale).
/// @throws InputError unless normals are unit, coefficients not negative, scale positive, all
/// finite. Source: [Ferrari1992] for the sets, [Howe1996] for the ellipsoid of soft fingers.
[[nodiscard]] WrenchSet wrench_set(const std::vector<Contact>& contacts,
                                   const Eigen::Vector3d& centre, double torque_scale);

/// Support function of the whole set:  kL1: the maximum over all caps;  kLinf: the sum over
/// contacts of their best cap, where positive.
[[nodiscard]] double support(const WrenchSet& set, const ScaledWrench& u, ForceNorm limit);

namespace internal {
/// Singular values, widths and distances below this part of the largest count as zero [1].
inline constexpr double kFlat = 1e-10;
}  // namespace internal

}  // namespace thenar
