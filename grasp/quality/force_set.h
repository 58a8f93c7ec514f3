#pragma once

/// Contact forces that a grasp may use, within friction and within what drives the hand.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "grasp/contact/contact.h"
#include "grasp/quality/cone_program.h"
#include "grasp/quality/wrench_set.h"
#include "hand/hand.h"

namespace thenar {

/// A convex set of contact forces y = (x, p, v, r), described as a cone programme does, with the
/// wrenches it makes on the object.
///
/// x holds of each contact its normal force [N], then its shares along the semi-axes of its cap:
/// the wrench of a contact is c x_0 + A x_1.., in its friction cone while |x_1..| <= x_0.
/// p holds normal forces that held drives bear: see hand_forces() [N].
/// v holds the efforts of actuators, each as a part of `effort_unit`; r holds reactions.
struct ForceSet {
  Eigen::Matrix<double, 6, Eigen::Dynamic> wrench;  // of y on the object (6, n)
  Eigen::MatrixXd A;                                // A y = b: torques balance (r, n)
  Eigen::VectorXd b;                                // (r)
  Eigen::MatrixXd G;                                // h - G y in the cones (m, n)
  Eigen::VectorXd h;                                // (m)
  std::vector<int> cones;                           // rows of each: those of contacts first
  Eigen::RowVectorXd normals;                       // sums the normal forces of y (n)
  std::vector<int> borne;                           // contact of each entry of p
  Eigen::VectorXd effort_unit;                      // of each actuator (actuators)
  int contacts = 0;
};

/// Forces in the friction cones, without limit.
[[nodiscard]] ForceSet free_forces(const WrenchSet& set);

/// Forces in the friction cones whose normal forces sum up to at most 1 N (L1), or are at most 1 N
/// each (Linf): the geometric measures of a grasp. Holds the zero force.
[[nodiscard]] ForceSet unit_forces(const WrenchSet& set, ForceLimit limit);

/// Forces in the friction cones that a hand can really balance, whatever moves on its part:
///   T x = B u + R r + tau_0,  lower <= u <= upper,  least <= r <= most.
/// Contacts with a part that cannot move, like a palm, need no effort: T has zeros for them. A
/// coordinate that no contact feels (a digit that does not touch) is asked nothing.
///
/// Held coordinates (worms) bear any torque, but do not press by themselves. So
/// * what a contact presses must come from the drive of the outermost held coordinate that feels
///   it; held ones further in bear it: x has zeros in their rows of T;
/// * what the load presses against such a contact counts by a normal force p >= 0 of its own, in
///   no row of a held coordinate. How much friction it brings depends on elasticity, and is left
///   out: the set is on the safe side;
/// * for the same reason contacts with structure (a palm, a locked link) push back by x no more in
///   all than the others press, and have a p as well. Without contacts on held parts they do not.
///
/// @param T  joint torques of contact forces, torque_map(), coordinates from the base outwards
///           (coordinates, length of x)
/// @throws InputError if shapes disagree, a limit is NaN, or a lower limit exceeds its upper.
/// Source: [Murray1994] section 5.5 for the balance of fingers, [HaasHeger2018] for drives that
/// bear more than they press.
[[nodiscard]] ForceSet hand_forces(const WrenchSet& set, const Eigen::MatrixXd& T,
                                   const Actuation& actuation);

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
  std::vector<Wrench> wrenches;  // of each contact on the object, torque / scale [N] (6)
  Eigen::VectorXd normal;        // force of each contact [N] (contacts)
  Eigen::VectorXd efforts;       // of each actuator (actuators)
};
[[nodiscard]] ContactForces contact_forces(const ForceSet& set, const Eigen::VectorXd& y);

}  // namespace thenar
