#pragma once

/// Where the digits of a robot end.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// The tip of a digit.
struct RobotTip {
  std::string digit;
  int link = 0;                // of the robot
  Eigen::Vector3d p{0, 0, 0};  // in the base link, reference posture [m] (3)
};

/// The end of each digit's outermost link, in the order in which digits appear: its origin if it
/// has no shapes; else the middle of the far face of its shapes' box, in its frame, on the side
/// where the box's centre lies, seen from the moving joint that carries it.
/// @param reference  pose of every link in the base link, at the reference posture
[[nodiscard]] std::vector<RobotTip> find_tips(const RobotSpec& robot,
                                              const std::vector<Pose<double>>& reference);

}  // namespace thenar
