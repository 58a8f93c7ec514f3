#pragma once

/// The answer of `thenar pose` about a robot.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

struct RobotJointNow {
  std::string name;
  std::string dof;  // that drives it; empty: none
  bool slides = false;
  double value = 0;       // [rad] or [m]
  Eigen::Vector3d axis;   // unit, in the base link (3)
  Eigen::Vector3d point;  // of the axis, in the base link [m] (3)
};

struct RobotLinkNow {
  std::string name;
  Pose<double> X_BL;  // its frame in the base link
};

struct RobotTipNow {
  std::string digit;
  std::string link;
  Eigen::Vector3d p;  // in the base link [m] (3)
};

struct RobotPose {
  std::string robot;
  std::vector<RobotJointNow> joints;  // that move
  std::vector<RobotLinkNow> links;
  std::vector<RobotTipNow> tips;
  std::vector<std::string> warnings;  // values outside limits
};

/// Where joints, links and tips of a robot are. Tips are those of find_tips(); digits that no file
/// states are those of infer_digits().
/// @param posture  NAME=value [deg], of slides [mm], of degrees of freedom or joints; or plain
/// values in the order of degrees of freedom; what is left out stands at 0
/// @throws InputError for an unknown name, a wrong count, what is no number, a joint that nothing
/// drives, or one that stands in two ways.
[[nodiscard]] RobotPose pose_robot(const RobotSpec& robot, const std::vector<std::string>& posture);

void print_text(const RobotPose& pose);
void print_json(const RobotPose& pose);

}  // namespace thenar
