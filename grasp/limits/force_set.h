#pragma once

/// Contact forces that a grasp may use, within friction and within what drives the hand.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "grasp/contact/contact.h"
#include "grasp/contact/wrench_set.h"
#include "hand/hand.h"
#include "solvers/cone_program.h"

namespace thenar {

/// A convex set of contact forces y = (x, p, v, r, s), described as a cone programme does, with the
/// wrenches it makes on the object.
///
/// x holds of each contact its normal force [N], then its shares along the semi-axes of its cap:
/// the wrench of a contact is c x_0 + A x_1.., in its friction cone while |x_1..| <= x_0.
/// p holds normal forces that the load presses on worms, stops and structure [N]; v the efforts of
/// actuators, each as a part of `effort_unit`; r reactions; s what stops push back [N]: see
/// hand_forces().
struct ForceSet {
  Eigen::Matrix<double, 6, Eigen::Dynamic> wrench;  // of y on the object (6, n)
  Eigen::MatrixXd A;                                // A y = b: torques balance (r, n)
  Eigen::VectorXd b;                                // (r)
  Eigen::MatrixXd G;                                // h - G y in the cones (m, n)
  Eigen::VectorXd h;                                // (m)
  std::vector<int> cones;                           // rows of each: those of contacts first
  Eigen::RowVectorXd normals;                       // sums the normal forces of y (n)
  std::vector<int> passive_contacts;                // contact of each entry of p
  std::vector<int> patch;       // of each contact: those of one number >= 0 are points of one face,
                                // -1: of its own
  Eigen::VectorXd effort_unit;  // of each actuator (actuators)
  int contacts = 0;
};

/// Forces in the friction cones, without limit.
[[nodiscard]] ForceSet free_forces(const WrenchSet& set);

/// Forces in the friction cones whose normal forces sum up to at most 1 N (L1), or are at most 1 N
/// each (Linf): the geometric measures of a grasp. Holds the zero force.
[[nodiscard]] ForceSet unit_forces(const WrenchSet& set, ForceNorm limit);

/// Forces in the friction cones that a hand can really balance, whatever moves on its part:
///   T x = B u + R r + tau_0,  lower <= u <= upper,  least <= r <= most.
/// Contacts with a part that cannot move, like a palm, need no effort: T has zeros for them. A
/// coordinate that no contact feels (a digit that does not touch) is asked nothing.
///
/// Worms (held coordinates), locks, stops and structure bear any torque, but press by no force of
/// their own: each normal force x_0 is pressed by an effort, or pushes back against such a one.
/// A coordinate presses a contact along the way T_jn / |(T_jn, T_jf)| of its normal, by its torques
/// of the normal force and of friction: if it is neither locked nor on a stop that the normal force
/// pushes it to, if no other's way is twice as good, and if it does work on some forces that cancel
/// out on the object (an arm moves all contacts alike, a link its own).
/// * Effort: some coordinate that no worm holds presses it; others may rest on their stops.
///   Friction does not jam it: of contacts that coordinate j presses the same way,
///     sum l x_0 <= largest torque of efforts at j,   l = max(|T_jn|, |T_jf|).
///   For forces that need no friction, T_jn is the larger and this is the balance itself.
/// * Worm: the outermost held coordinate that presses the contact does so by its drive, limited as
///   above; other held ones bear it, and their stops count for nothing: x has zeros in their rows
///   of T.
/// * Stop: nothing presses it, but a stop could bear it. x_0 = a + s: of those whose longest lever
///   is to j, sum |T_jn| a <= B_j u + tau_0j (clutches too); s >= 0 is what stops push back,
///   sum s <= sum x_0 of efforts and worms.
/// * Structure: neither presses nor could bear it.
///     sum x_0 of structure + sum s <= sum x_0 of efforts and worms + sum a.
/// What the load presses on the last three counts by a normal force p >= 0 of its own without
/// friction, in no row of a held coordinate. How much friction a load brings depends on elasticity
/// and is left out, as are wedges that would make more normal force than presses them: the set is
/// on the safe side. a = 0 of a joint whose springs no effort overcomes, and of all where no
/// efforts balance all joints without pulling some onto stops.
///
/// @param T  joint torques of contact forces, torque_map(), coordinates from the base outwards
///           (coordinates, length of x)
/// @throws InputError if shapes disagree, a limit is NaN, or a lower limit exceeds its upper.
/// Source: [Murray1994] section 5.5 for the balance of fingers, [HaasHeger2018] for drives that
/// bear more than they press.
[[nodiscard]] ForceSet hand_forces(const WrenchSet& set, const Eigen::MatrixXd& T,
                                   const Actuation& actuation);

/// The same without p: what efforts press, and what pushes back against that.
[[nodiscard]] ForceSet active_only(ForceSet forces);

/// Joint torques by which a hand holds against unit contact forces:  T x = sum_i J_i' (f_i, m_i).
///
/// @param q         posture of the hand  (coordinates)
/// @param contacts  in the object's frame; those of the wrench set, in its order
/// @param X_HO      the object seen from the hand
/// @returns [N m] per N (coordinates, length of x)
/// @throws InputError if a contact names no surface of the hand.
[[nodiscard]] Eigen::MatrixXd torque_map(const Hand& hand, const Eigen::VectorXd& q,
                                         const std::vector<HandContact>& contacts,
                                         const Pose<double>& X_HO);

/// What a point y of a force set means.
struct ContactForces {
  std::vector<ScaledWrench> wrenches;  // of each contact on the object, torque / scale [N] (6)
  Eigen::VectorXd normal;              // force of each contact [N] (contacts)
  Eigen::VectorXd efforts;             // of each actuator (actuators)
};
[[nodiscard]] ContactForces contact_forces(const ForceSet& set, const Eigen::VectorXd& y);

}  // namespace thenar

namespace thenar::internal {

// How sets of forces grow: rows of limits, columns of variables.

/// Adds rows  rows y <= most,  each a cone of its own.
void add_rows(ForceSet& forces, const Eigen::MatrixXd& rows, const Eigen::VectorXd& most);

/// Appends variables that nothing sees yet.
void widen(ForceSet& forces, Eigen::Index by);

}  // namespace thenar::internal
