#pragma once

/// Poses of the joints, links and tips of a robot.
///
///     const RobotPoses poses = pose_robot(import_robot("gripper.urdf"), {});

#include <string>
#include <vector>

#include "api/pose_request.h"
#include "base/progress.h"
#include "data/io/robot/robot.h"
#include "solvers/status.h"

namespace thenar {

/// Moving joint at one posture.
struct RobotJointPose {
  std::string name;       // as in the robot's file
  std::string dof;        // degree of freedom that drives it; empty: none
  bool slides = false;    // true: lengths in m; false: angles in rad
  double value = 0;       // [rad] or [m]
  Eigen::Vector3d axis;   // unit, in the base link (3)
  Eigen::Vector3d point;  // point on the axis, in the base link [m] (3)
};

/// Link at one posture.
struct RobotLinkPose {
  std::string name;   // as in the robot's file
  int parent;         // index of its parent link; -1: none
  Pose<double> X_BL;  // pose of its frame in the base link
};

/// Tip at one posture.
struct RobotTipPose {
  std::string digit;  // name of the digit
  std::string link;   // name of the link that ends in it
  Eigen::Vector3d p;  // position in the base link [m] (3)
};

/// Robot at one posture.
struct RobotPose {
  std::vector<double> varied;          // values of the varied coordinates [rad] or [m]
  std::vector<RobotJointPose> joints;  // joints that move
  std::vector<RobotLinkPose> links;    // all links
  std::vector<RobotTipPose> tips;      // tips of all digits
  std::vector<std::string> warnings;   // values outside limits
};

/// Degree of freedom or joint that varies.
struct VariedDrive {
  std::string name;     // as in the robot's file
  bool slides = false;  // true: lengths in m; false: angles in rad
};

/// Poses of a robot, posture by posture; fewer if stopped.
struct RobotPoses {
  PoseRequest request;              // request that was answered
  Outcome outcome;                  // warnings: values outside limits at any posture
  std::string robot;                // name of the robot
  std::vector<VariedDrive> varied;  // the last one varies fastest; empty: one posture
  std::size_t row = 1;            // number of postures in a row, which differ in the last one only
  std::vector<RobotPose> points;  // one pose for each posture
  FileDigests files = {};         // digests of the robot's files
};

/// Computes the poses of a robot's joints, links and tips. Tips are those of find_tips(); where no
/// file states digits, they come from infer_digits().
/// @param request  posture of degrees of freedom or joints by name, or of all degrees of freedom in
/// order, in [rad], of slides [m], or as typed in [deg], [mm]; the others are at 0. Varied
/// coordinates have the same names and units
/// @throws InputError for an unknown name, a wrong count, a joint without drive, contradictory
/// values of a joint, or steps that do not lead to their end
[[nodiscard]] RobotPoses pose_robot(const RobotSpec& robot, const PoseRequest& request,
                                    const Progress& progress = {});

}  // namespace thenar
