#pragma once

/// Points, faces and boxes of a hand's surfaces at given link poses, in the hand's frame.

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "base/spatial.h"
#include "grasp/robot/ball_grasp.h"

namespace thenar {

/// Finds the palm: surfaces without a digit on the outermost link that has any.
[[nodiscard]] std::vector<std::size_t> palm_surfaces(const BallGrasp& grip);

/// Returns points of surfaces at given link poses (3, points) [m].
/// @param links  RobotHand::pose()
[[nodiscard]] Eigen::Matrix3Xd points_of(const BallGrasp& grip,
                                         const std::vector<std::size_t>& surfaces,
                                         const std::vector<Pose<double>>& links);

/// Returns faces of surfaces at given link poses (3, faces) [m^2].
/// @param links  RobotHand::pose()
[[nodiscard]] Eigen::Matrix3Xd faces_of(const BallGrasp& grip,
                                        const std::vector<std::size_t>& surfaces,
                                        const std::vector<Pose<double>>& links);

/// Returns the bounding box of surfaces at given link poses, its sides along the columns of R [m].
/// @param links  RobotHand::pose()
[[nodiscard]] Eigen::AlignedBox3d box_of(const BallGrasp& grip,
                                         const std::vector<std::size_t>& surfaces,
                                         const std::vector<Pose<double>>& links,
                                         const Eigen::Matrix3d& R);

}  // namespace thenar
