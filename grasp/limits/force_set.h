#pragma once

/// Contact forces that a grasp may use, within friction and within the torques of the hand.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "grasp/contact/contact.h"
#include "grasp/contact/wrench_set.h"
#include "hand/hand.h"
#include "solvers/cone_program.h"

namespace thenar {

/// A convex set of contact forces y = (x, p, v, r, s), in the form of a cone program, with the
/// wrenches that they make on the object.
///
/// x    active forces: for each contact its normal force [N], then its shares along the semi-axes
/// of
///      its cap. The wrench of a contact is c x_0 + A x_1.., in its friction cone while |x_1..| <=
///      x_0
/// p    passive normal forces, by which the load presses contacts on non-backdrivable drives, joint
///      limits and structure [N]
/// v    efforts of actuators, each in units of `effort_unit`
/// r    reactions of locks, clutches and joint limits [N m]
/// s    forces by which joint limits push back against active ones [N]; see hand_forces()
struct ForceSet {
  Eigen::Matrix<double, 6, Eigen::Dynamic> wrench;  // of y on the object, rows as
                                                    // WrenchCoordinates (6, n)
  Eigen::MatrixXd A;                                // A y = b: torques balance (r, n)
  Eigen::VectorXd b;                                // (r)
  Eigen::MatrixXd G;                                // h - G y in the cones (m, n)
  Eigen::VectorXd h;                                // (m)
  std::vector<int> cones;                           // rows of each cone: those of contacts first
  Eigen::RowVectorXd normals;                       // sums the normal forces of y (n)
  std::vector<int> passive_contacts;                // contact of each entry of p
  std::vector<int> patch;       // of each contact: points of one face share a number >= 0;
                                // -1: a patch of its own
  Eigen::VectorXd effort_unit;  // of each actuator (actuators)
  int contacts = 0;
};

/// Forces in the friction cones, unlimited.
[[nodiscard]] ForceSet free_forces(const WrenchSet& set);

/// Forces in the friction cones whose normal forces sum up to at most 1 N (L1), or are at most 1 N
/// each (Linf): the sets of the geometric quality measures. They contain the zero force.
[[nodiscard]] ForceSet unit_forces(const WrenchSet& set, ForceNorm limit);

/// Contact forces in the friction cones that joint torques of the hand can balance:
///   T x = B u + R r + tau_0,  lower <= u <= upper,  least <= r <= most.
/// Contacts with a part that cannot move, like a palm, have zeros in T and need no effort. A
/// coordinate that feels no contact (a digit that does not touch) is left out.
///
/// Support: efforts press a contact (active); non-backdrivable drives, joint limits and structure
/// only support it (passive). docs/theory/grasp_quality.md, "Who supports a contact", has the
/// rules. Active forces need no help of friction: of the contacts that coordinate j presses the
/// same way,
///   sum l x_0 <= largest torque of efforts at j,   l = max(|T_jn|, |T_jf|).
/// Preload: joint limits and structure push back at most as much as actuators press.
/// Load: what it presses on passive contacts is a normal force p >= 0 without friction, felt by no
/// non-backdrivable coordinate. Friction that a load brings, and wedging, are left out, because
/// they depend on elasticity; the set is on the safe side.
/// @param T  joint torques of contact forces, torque_map(), coordinates from the base outwards
///           (coordinates, length of x) [m]
/// @param preload_slack  share by which structure may push back more than actuators press [1]:
///        where one wall takes all that they press, and another touches, the set has no interior
/// @throws InputError if shapes disagree, a limit is NaN, or a lower limit exceeds its upper.
/// Source: [Murray1994] section 5.5 for the balance of fingers, [HaasHeger2018] for drives that
/// support more than they press.
[[nodiscard]] ForceSet hand_forces(const WrenchSet& set, const Eigen::MatrixXd& T,
                                   const Actuation& actuation, double preload_slack = 0);

/// A load without its parts along which no force of a set bears anything, where they are at most
/// 1e-4 of it: two points bear no torque about their line, and places of contacts are not known so
/// well that it would pass the centre of mass exactly.
/// @param load  torque over the scale  (6)
[[nodiscard]] ScaledWrench bearable_part(const ForceSet& forces, const ScaledWrench& load);

/// Returns the set without passive forces p: active forces, and what pushes back against them.
[[nodiscard]] ForceSet active_only(ForceSet forces);

/// Joint torques that balance unit contact forces:  T x = sum_i J_i' (f_i, m_i).
///
/// @param q         posture of the hand  (coordinates)
/// @param contacts  in the object's frame, in the order of the wrench set
/// @param X_HO      pose of the object in the hand's frame
/// @returns [N m] per N (coordinates, length of x)
/// @throws InputError if a contact names no surface of the hand.
[[nodiscard]] Eigen::MatrixXd torque_map(const Hand& hand, const Eigen::VectorXd& q,
                                         const std::vector<HandContact>& contacts,
                                         const Pose<double>& X_HO);

/// Contact wrenches, normal forces and efforts at a point y of a force set.
struct ContactForces {
  std::vector<ScaledWrench> wrenches;  // of each contact on the object
  Eigen::VectorXd normal;              // force of each contact [N] (contacts)
  Eigen::VectorXd efforts;             // of each actuator [N m] or [N] (actuators)
};
/// The contact forces and efforts that y stands for. @param y  as ForceSet  (n)
[[nodiscard]] ContactForces contact_forces(const ForceSet& set, const Eigen::VectorXd& y);

}  // namespace thenar

namespace thenar::internal {

/// Appends the limits  rows y <= most,  each a cone of its own. @param rows  (k, n) @param most (k)
void add_rows(ForceSet& forces, const Eigen::MatrixXd& rows, const Eigen::VectorXd& most);

/// Appends variables that no row uses yet.
void widen(ForceSet& forces, Eigen::Index by);

}  // namespace thenar::internal
