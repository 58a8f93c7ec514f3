#pragma once

/// Manipulability of a held object: the ability of the hand to move it.

#include <Eigen/Core>

namespace thenar {

/// Measures of the singular values of a map.
struct Manipulability {
  double volume = 0;              // product of all singular values, sqrt(det M M')
  double min_singular_value = 0;  // smallest singular value: that of the worst direction
  double isotropy = 0;  // smallest over largest; 1: equal in all directions, 0: singular [1]
  int rank = 0;         // number of singular values above 1e-12 of the largest
};

/// Computes manipulability measures of a Jacobian or a grasp map M (rows <= columns for full rank):
///   w = sqrt(det(M M')) = sigma_1 sigma_2 ... sigma_r,  1 / cond(M) = sigma_r / sigma_1.
/// Below full row rank w and the smallest value are 0. All rows should have one unit: scale torques
/// and rotations first.
/// @throws InputError if an entry is not finite
/// Source: [Yoshikawa1985] for the volume, [Salisbury1982] for the isotropy.
[[nodiscard]] Manipulability manipulability(const Eigen::MatrixXd& M);

/// Computes the object velocity per joint velocity,  H = (G')^+ J:  the least-squares solution nu
/// of G' nu = J q_dot, the condition that contacts neither slip nor separate.
///
/// @param G  wrenches of unit contact force components  (6, k), rank 6 for a unique answer
/// @param J  velocities of the hand along these components (k, n)
/// @throws InputError if shapes disagree or an entry is not finite
/// Source: [Li1988].
[[nodiscard]] Eigen::MatrixXd hand_object_jacobian(
    const Eigen::Matrix<double, 6, Eigen::Dynamic>& G, const Eigen::MatrixXd& J);

/// Drive speeds that are possible without slip, and the motion of the object.
struct NoSlipMobility {
  Eigen::MatrixXd drives;  // orthonormal basis of the allowed drive speeds (drives, k)
  Eigen::MatrixXd object;  // velocity of the object at each basis vector; exactly 0 below rounding,
                           // 1e-12 |J| / (smallest singular value of G) (6, k)
};

/// Computes the mobility of an object in a grasp without slip. Contacts that neither slip nor
/// separate require  G' nu = J s  with the object's velocity nu. The allowed drive speeds s are
/// those for which such a nu exists, the null space of the part of J across the range of G':
///   (I - G' (G')^+) J s = 0,   nu = (G')^+ J s.
/// Least squares alone would allow motions that contacts prevent: jaws of one motor would seem to
/// move the object that they hold.
///
/// @param G  wrenches of unit contact force components, torques over their scale  (6, k)
/// @param J  velocities of the hand along these components per drive speed  (k, drives)
/// @param tolerance  fraction of the largest singular value of J up to which others are zero [1]
/// @throws InputError if shapes disagree, an entry is not finite, or the rank of G is below 6, so
/// that the contacts do not constrain the object.
/// Source: [Li1988] for the relation, [Murray1994] section 5.5 for the allowed motions.
[[nodiscard]] NoSlipMobility no_slip_mobility(const Eigen::Matrix<double, 6, Eigen::Dynamic>& G,
                                              const Eigen::MatrixXd& J, double tolerance = 1e-6);

}  // namespace thenar
