#pragma once

/// Contact forces that a grasp can exert, within friction and within the torques of the hand.

#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "grasp/contact/contact.h"
#include "grasp/contact/wrench_set.h"
#include "hand/hand.h"
#include "solvers/cone_program.h"

namespace thenar {

/// Convex set of contact forces y = (x, p, v, r, s), in the form of a cone program, with the
/// wrenches that they exert on the object.
///
/// x    active forces: for each contact its normal force [N], then its components along the
///      semi-axes of its cap. The wrench of a contact is c x_0 + A x_1.., in its friction cone
///      while |x_1..| <= x_0
/// p    passive normal forces, by which the load presses contacts on non-backdrivable drives, joint
///      limits and structure [N]
/// v    efforts of actuators, each in units of `effort_unit`
/// r    reactions of locks, clutches and joint limits [N m]
/// s    forces by which joint limits push back against active ones [N]; see hand_forces()
struct ForceSet {
  /// Wrenches of unit entries of y on the object, rows as WrenchCoordinates (6, n).
  Eigen::Matrix<double, 6, Eigen::Dynamic> wrench;
  Eigen::MatrixXd A;                  // A y = b: balance of torques (r, n)
  Eigen::VectorXd b;                  // (r)
  Eigen::MatrixXd G;                  // h - G y lies in the cones (m, n)
  Eigen::VectorXd h;                  // (m)
  std::vector<int> cones;             // number of rows of each cone; cones of contacts first
  Eigen::RowVectorXd normals;         // sum of the normal forces of y (n)
  std::vector<int> passive_contacts;  // contact of each entry of p
  std::vector<int> patch;  // patch of each contact: points of one face share a number >= 0; -1: a
                           // patch of its own
  Eigen::VectorXd effort_unit;  // effort unit of each actuator [N m] or [N] (actuators)
  int contacts = 0;             // number of contacts
};

/// Returns the set of all forces in the friction cones, without limit.
[[nodiscard]] ForceSet free_forces(const WrenchSet& set);

/// Returns the set of forces in the friction cones whose normal forces add up to at most 1 N (L1),
/// or are at most 1 N each (Linf): the sets of the geometric quality measures. They contain the
/// zero force.
[[nodiscard]] ForceSet unit_forces(const WrenchSet& set, ForceNorm limit);

/// Builds the set of contact forces in the friction cones that joint torques of the hand can
/// balance:
///   T x = B u + R r + tau_0,  lower <= u <= upper,  r_lower <= r <= r_upper.
/// Contacts with a part that cannot move, such as a palm, have zeros in T and need no effort. A
/// coordinate that carries no contact force (a digit without contact) is left out.
///
/// Support: efforts press a contact (active); non-backdrivable drives, joint limits and structure
/// only support it (passive). docs/theory/grasp_quality.md, "Who supports a contact", has the
/// rules. Active forces must not rely on friction: of the contacts that coordinate j presses in the
/// same direction,
///   sum l x_0 <= maximum torque of efforts at j,   l = max(|T_jn|, |T_jf|).
/// Preload: joint limits and structure push back at most as much as actuators press.
/// Load: what it presses on passive contacts is a normal force p >= 0 without friction, which loads
/// no non-backdrivable coordinate. Friction caused by a load, and wedging, are neglected, because
/// they depend on elasticity; the set is conservative.
/// @param T  joint torques of contact forces, torque_map(), coordinates from the base outwards
///           (coordinates, length of x) [m]
/// @param preload_slack  fraction by which structure may push back more than actuators press [1];
///   without it the set has no interior if one wall takes all that they press and another touches
/// @throws InputError if shapes disagree, a limit is NaN, or a lower limit exceeds its upper.
/// Source: [Murray1994] section 5.5 for the balance of fingers, [HaasHeger2018] for drives that
/// support more than they press.
[[nodiscard]] ForceSet hand_forces(const WrenchSet& set, const Eigen::MatrixXd& T,
                                   const Actuation& actuation, double preload_slack = 0);

/// Removes the components of a load that no force of a set can resist, where they are at most 1e-4
/// of it: two points resist no torque about their line, and contact positions are not exact enough
/// for the line to pass through the centre of mass.
/// @param load  torque over the scale  (6)
[[nodiscard]] ScaledWrench resistible_part(const ForceSet& forces, const ScaledWrench& load);

/// Returns the set without passive forces p: active forces, and the reactions to them.
[[nodiscard]] ForceSet active_only(ForceSet forces);

/// Computes the joint torques that balance unit contact forces:  T x = sum_i J_i' (f_i, m_i).
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
  std::vector<ScaledWrench> wrenches;  // wrench of each contact on the object
  Eigen::VectorXd normal;              // normal force of each contact [N] (contacts)
  Eigen::VectorXd efforts;             // effort of each actuator [N m] or [N] (actuators)
};
/// Computes the contact forces and efforts of a point y of the set. @param y  as ForceSet  (n)
[[nodiscard]] ContactForces contact_forces(const ForceSet& set, const Eigen::VectorXd& y);

}  // namespace thenar

namespace thenar::internal {

/// Appends the limits  rows y <= upper  to a force set or a cone program, each as a cone of its
/// own.
/// @param rows  (k, n);  @param upper  (k)
template <typename Program>
void append_limits(Program& program, const Eigen::MatrixXd& rows, const Eigen::VectorXd& upper) {
  const Eigen::Index old = program.G.rows();
  program.G.conservativeResize(old + rows.rows(), program.G.cols());
  program.G.bottomRows(rows.rows()) = rows;
  program.h.conservativeResize(old + rows.rows());
  program.h.tail(rows.rows()) = upper;
  program.cones.insert(program.cones.end(), static_cast<std::size_t>(rows.rows()), 1);
}

/// Appends one such limit.
template <typename Program>
void append_limit(Program& program, const Eigen::RowVectorXd& row, double upper) {
  append_limits(program, row, Eigen::VectorXd::Constant(1, upper));
}

/// Appends a variable with zero coefficients to a cone program.
void append_variable(ConeProgram& program);

/// Appends variables that no row uses yet. @param count  number of variables
void append_variables(ForceSet& forces, Eigen::Index count);

}  // namespace thenar::internal
