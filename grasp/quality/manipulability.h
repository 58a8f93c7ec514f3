#pragma once

/// How well a hand moves what it holds.

#include <Eigen/Core>

namespace thenar {

/// Singular values of a map in one look.
struct Manipulability {
  double volume;    // product of all singular values, sqrt(det M M')
  double least;     // smallest singular value: the worst direction
  double isotropy;  // smallest by largest, 1: alike in all directions, 0: singular [1]
  int rank;         // singular values above 1e-12 of the largest
};

/// Of a Jacobian or a grasp map M (rows <= columns where it is to reach everything):
///   w = sqrt(det(M M')) = sigma_1 sigma_2 ... sigma_r,  1 / cond(M) = sigma_r / sigma_1.
/// A map of a rank below its rows, or none, reaches no volume: w and the least value are 0. Rows
/// ought to have one unit: scale torques and rotations first.
/// @throws InputError if an entry is not finite
/// Source: [Yoshikawa1985] for the volume, [Salisbury1982] for the isotropy.
[[nodiscard]] Manipulability manipulability(const Eigen::MatrixXd& M);

/// Object velocity per joint velocity,  H = (G')^+ J:  what contacts that neither slip nor part
/// impose, G' nu = J q_dot, solved for nu in least squares.
///
/// @param G  wrenches of unit contact force components  (6, k), rank 6 for a unique answer
/// @param J  velocities of the hand along these components (k, n)
/// @throws InputError if shapes disagree or an entry is not finite
/// Source: [Li1988].
[[nodiscard]] Eigen::MatrixXd hand_object_jacobian(
    const Eigen::Matrix<double, 6, Eigen::Dynamic>& G, const Eigen::MatrixXd& J);

// Which motions of a held object drives can make without slip.

/// Speeds of drives that contacts allow, and what they do to the object.
struct NoSlipMobility {
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
[[nodiscard]] NoSlipMobility no_slip_mobility(const Eigen::Matrix<double, 6, Eigen::Dynamic>& G,
                                              const Eigen::MatrixXd& J, double tolerance = 1e-6);

}  // namespace thenar
