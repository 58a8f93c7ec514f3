#pragma once

/// Joint axes of any hand, for drawing and dragging, and couplings between its joints.

#include <vector>

#include <Eigen/Core>

#include "hand/hand.h"

namespace thenar {

/// Axis of a coordinate, fixed to the first link that the coordinate moves.
struct HandJoint {
  int coordinate = -1;
  int link = -1;                   // first link from the base that the coordinate moves
  Eigen::Vector3d axis{0, 0, 1};   // unit axis, link frame (hand frame at reference posture) (3)
  Eigen::Vector3d point{0, 0, 0};  // point on the axis nearest to the link's centre, link frame [m]
  bool slides = false;             // true: prismatic, false: revolute (right-hand rule)
};

/// Computes the axes of all coordinates that move a link, from Jacobians. With the angular column w
/// and the linear column v of the Jacobian at a point p, both in the base's frame,
///   axis = w / |w|,  point = p + w x v / |w|^2,  or axis = v / |v| where w is zero: it slides.
/// @throws InputError if a coordinate turns and slides its first link at once.
[[nodiscard]] std::vector<HandJoint> hand_joints(const Hand& hand);

/// Coupling of a joint to the leading joint of its drive, valid while nothing touches the digit.
struct JointCoupling {
  int leader = -1;   // leading coordinate; -1: the joint is not coupled
  double ratio = 0;  // motion of the joint over that of its leader [rad/rad], [m/m], ..
};

/// Finds the coupling of each coordinate (coordinates). In a robot the first coordinate of a drive
/// leads the others with the ratio of their gears. Joints of tendon-driven hands are not coupled.
[[nodiscard]] std::vector<JointCoupling> joint_couplings(const Hand& hand);

}  // namespace thenar
