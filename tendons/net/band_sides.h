#pragma once

/// Sides on which bands pass cylinders.

#include <Eigen/Core>

#include "hand/skeleton.h"
#include "tendons/net/net.h"

namespace thenar {

/// Turns the side of every band over a cylinder to the middle of the angles that its ends take in
/// the straight finger and while each joint between them moves through its range. So no end reaches
/// the half plane opposite to the side, where the band would switch to the far side of the cylinder
/// and its length would jump.
/// @param straight  posture of the straight finger (coordinates) [rad]
void centre_sides(const Skeleton& skeleton, const Eigen::VectorXd& straight, Net& net);

}  // namespace thenar
