#pragma once

/// Motion of a held object by the drives of the hand, while no contact slips.

#include <string>

#include <Eigen/Core>

#include "grasp/closing/setup.h"
#include "grasp/contact/contact.h"
#include "grasp/quality/manipulability.h"
#include "hand/hand.h"

namespace thenar {

/// The object's velocity, turns times its reach, per drive speed of no_slip_mobility().
struct ObjectMotion {
  Manipulability manipulability;
  Eigen::VectorXd speeds;  // singular values, descending: of what drives can do without slip
  int drives;              // motors, or joints that are actuated by themselves
  std::string unit;        // "m/rad", "m/m", or "m/rad or m/m" where drives are of both kinds
};

/// Velocities of coordinates per drive speed: a column of ratios for each of HandLayout::drives,
/// and one for each coordinate that no drive moves and an actuator does. Clutches and springs are
/// taken for rigid.
/// @param q  (coordinates) [rad] or [m]
/// @return (coordinates, drives)
[[nodiscard]] Eigen::MatrixXd drive_ratios(const Hand& hand, const Eigen::VectorXd& q);

/// Unit components of all contacts: normal, both tangents where there is friction, and the turn
/// about the normal, times the reach, where there is torsion.
/// @param T  torque_map() of the same contacts
/// @throws InputError as no_slip_mobility(): the contacts leave the object free.
[[nodiscard]] ObjectMotion object_motion(const Hand& hand, const Eigen::VectorXd& q,
                                         const std::vector<Contact>& contacts,
                                         const GraspBody& object, const Eigen::MatrixXd& T);

}  // namespace thenar
