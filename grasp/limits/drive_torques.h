#pragma once

/// What the motors of drives can do at the joints, and what their gears and clutches bear.

#include "hand/hand.h"

namespace thenar {

struct DriveTorques {
  Eigen::MatrixXd B;  // torques of unit efforts of the drives (coordinates, drives)
  Reactions reactions;
};

/// How each drive's effort u comes to its coordinates, which move by r per unit of the drive.
///
/// Rigid and compliant drives:  tau = u r / (r'r), which has the motor's power whenever the joints
/// move by their ratios; no other split of that power has smaller joint torques (least norm).
///
/// Breakaway: joints that lag behind the drive's farthest have been left by their clutch. Each
/// keeps a torque c between 0 and `breakaway` in the way of closing, and the motor drives the
/// others. Of those, the outermost gets what the clutches of the inner ones leave,
///   tau_outer = (u - sum r_i c_i) / r_outer,  tau_i = c_i.
/// |c_i| <= breakaway; if the drive is held, c_i does not drive the motor back: 0 <= c_i.
///
/// A drive that is not backdrivable holds its coordinates, and locks them if it stays where it is
/// in closing (speed 0): a reaction without limit both ways.
///
/// @param q  posture (coordinates) [rad], of sliding joints [m]
/// Source: [BarrettSupport] for the clutch and worms of a finger.
[[nodiscard]] DriveTorques drive_torques(const HandLayout& layout, const Eigen::VectorXd& q);

}  // namespace thenar
