#pragma once

/// Wrench sets of contacts: wrenches within the exact (round) friction cones.

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
  /// Caps with one number >= 0 share the limit of a contact; -1: a limit of its own.
  int contact = -1;
};

/// Wrenches of all contacts of a grasp.
struct WrenchSet {
  std::vector<WrenchCap> caps;  // one for each contact point, or several with one number
};

/// Norm of the contact forces that is limited.
enum class ForceNorm {
  kL1,   // sum of all normal forces at most 1: the convex hull of the caps
  kLinf  // normal force of each patch, summed over its points, at most 1: the Minkowski sum over
         // patches of conv({0} + caps)
};
inline constexpr std::array kForceNormNames{EnumName{ForceNorm::kL1, "l1"},
                                            EnumName{ForceNorm::kLinf, "linf"}};

/// Computes the wrench caps of contacts about a centre, torques divided by `torque_scale`; contacts
/// of one region (contact_regions()) share a number. The set does not depend on the number of
/// points of a patch: the cap of a point between others with the same normal and friction is a
/// convex combination of theirs.
///   c = (n, (p - centre) x n / scale),  semi-axes mu (t, (p - centre) x t / scale) for tangents
///   t = t1, t2, and (0, torsion n / scale).
/// @throws InputError unless normals are unit, coefficients not negative, scale positive, all
/// finite. Source: [Ferrari1992] for the sets, [Howe1996] for the ellipsoid of soft fingers.
[[nodiscard]] WrenchSet wrench_set(const std::vector<Contact>& contacts,
                                   const Eigen::Vector3d& centre, double torque_scale);

/// Returns the frictionless unit wrench and the semi-axes of each cap as columns (6, n).
[[nodiscard]] Eigen::Matrix<double, 6, Eigen::Dynamic> wrench_columns(const WrenchSet& set);

/// Computes the support function of the whole set:  kL1: the maximum over all caps;  kLinf: the sum
/// over contacts of the maximum of their caps, where positive.
[[nodiscard]] double support(const WrenchSet& set, const ScaledWrench& u, ForceNorm limit);

namespace internal {
/// Singular values, widths and distances below this fraction of the largest count as zero [1]
inline constexpr double kWrenchRankTolerance = 1e-10;
}  // namespace internal

}  // namespace thenar
