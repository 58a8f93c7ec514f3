#pragma once

/// Motion of a held object by the drives of the hand, without slip at any contact.

#include <string>

#include <Eigen/Core>

#include "grasp/closing/setup.h"
#include "grasp/contact/contact.h"
#include "grasp/quality/manipulability.h"
#include "hand/hand.h"

namespace thenar {

/// Velocity of the object per drive speed of no_slip_mobility(), with its angular velocity times
/// its radius.
struct ObjectMotion {
  Manipulability manipulability;
  Eigen::VectorXd
      speeds;        // singular values of the motions that drives allow without slip, descending
  int drives = 0;    // number of drives: motors, or joints with an actuator of their own
  std::string unit;  // "m/rad", "m/m", or "m/rad or m/m" where drives are of both kinds
};

/// Computes velocities of coordinates per drive speed: a column of ratios for each of
/// HandLayout::drives, and one for each coordinate that an actuator moves without a drive. Clutches
/// and springs are treated as rigid.
/// @param q  (coordinates) [rad] or [m]
/// @return (coordinates, drives)
[[nodiscard]] Eigen::MatrixXd drive_ratios(const Hand& hand, const Eigen::VectorXd& q);

/// Computes the motion of a held object from unit components of all contacts: normal, both tangents
/// where there is friction, and the rotation about the normal, times the radius, where there is
/// torsion.
/// @param T  torque_map() of the same contacts
/// @throws InputError as no_slip_mobility(), if the contacts do not constrain the object.
[[nodiscard]] ObjectMotion object_motion(const Hand& hand, const Eigen::VectorXd& q,
                                         const std::vector<Contact>& contacts,
                                         const GraspBody& object, const Eigen::MatrixXd& T);

}  // namespace thenar
