#pragma once

/// Tips of a robot's digits.

#include <string>
#include <vector>

#include "data/io/robot/robot.h"

namespace thenar {

/// Tip of a digit.
struct RobotTip {
  std::string digit;
  int link = 0;                // link of the robot
  Eigen::Vector3d p{0, 0, 0};  // position in the base link, reference posture [m] (3)
};

/// Finds the end of each digit's outermost link, in the order in which digits appear: the link's
/// origin if it has no shapes; otherwise the centre of the far face of the bounding box of its
/// shapes, in its frame, on the side of the box's centre as seen from the moving joint that carries
/// the link.
/// @param reference  pose of every link in the base link, at the reference posture
[[nodiscard]] std::vector<RobotTip> find_tips(const RobotSpec& robot,
                                              const std::vector<Pose<double>>& reference);

}  // namespace thenar
