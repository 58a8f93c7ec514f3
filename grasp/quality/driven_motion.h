#pragma once

/// Which motions of a held object drives can make without slip.

#include <Eigen/Core>

namespace thenar {

/// Speeds of drives that contacts allow, and what they do to the object.
struct DrivenMotion {
  Eigen::MatrixXd drives;  // orthonormal columns: a basis of allowed drive speeds (drives, k)
  Eigen::MatrixXd object;  // the object's velocity at each of them, exactly 0 where it is less than
                           // rounding, 1e-12 |J| / (least singular value of G) (6, k)
};

/// Contacts that neither slip nor part ask for  G' nu = J s  with the object's velocity nu. Only
/// drive speeds s for which some nu meets it are kept, the null space of what is left of J beside
/// the range of G':
///   (I - G' (G')^+) J s = 0,   nu = (G')^+ J s.
/// Least squares without that step would give motions that contacts forbid: jaws of one motor would
/// seem to move what they hold.
///
/// @param G  wrenches of unit contact force components, torques over their scale  (6, k)
/// @param J  velocities of the hand along them per drive speed  (k, drives)
/// @param tolerance  singular values up to this share of the largest one of J are zero [1]
/// @throws InputError if shapes disagree, an entry is not finite, or G has a rank below 6: the
/// object could move by itself.
/// Source: [Li1988] for the relation, [Murray1994] section 5.5 for which motions it leaves.
[[nodiscard]] DrivenMotion driven_motion(const Eigen::Matrix<double, 6, Eigen::Dynamic>& G,
                                         const Eigen::MatrixXd& J, double tolerance = 1e-6);

}  // namespace thenar
