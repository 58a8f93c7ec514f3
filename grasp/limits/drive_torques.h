#pragma once

/// Joint torques of motors through their drives, and the reactions of gears and clutches.

#include "hand/hand.h"

namespace thenar {

/// Torques and reactions of the drives of a hand.
struct DriveTorques {
  Eigen::MatrixXd B;  // torques of unit efforts of the drives (coordinates, drives)
  Reactions reactions;
};

/// Computes the torques of each drive's effort u at its coordinates, which move by r per unit of
/// the drive.
///
/// Rigid and compliant drives:  tau = u r / (r'r). This has the motor's power whenever the joints
/// move by their ratios, and the smallest norm of all torques that do.
///
/// Breakaway drives: joints that lag behind the farthest joint of the drive have been released by
/// their clutch. Each keeps a torque c between 0 and `breakaway` in the direction of closing, and
/// the motor drives the others. The outermost of these gets what the clutches of the inner ones
/// leave,
///   tau_outer = (u - sum r_i c_i) / r_outer,  tau_i = c_i.
/// |c_i| <= breakaway; if the drive is not backdrivable, c_i does not drive the motor back: 0 <=
/// c_i.
///
/// A drive that is not backdrivable holds its coordinates; if it does not move in closing (speed
/// 0), it locks them: an unlimited reaction in both directions.
///
/// @param q  posture (coordinates) [rad], of sliding joints [m]
/// Source: [BarrettSupport] for the clutch and the worm gears of a finger.
[[nodiscard]] DriveTorques drive_torques(const HandLayout& layout, const Eigen::VectorXd& q);

}  // namespace thenar
