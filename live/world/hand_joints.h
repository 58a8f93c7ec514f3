#pragma once

/// Axes of the joints of any hand, as they are drawn and dragged, and joints that lead others.

#include <vector>

#include <Eigen/Core>

#include "hand/hand.h"

namespace thenar {

/// Axis of a coordinate: that of the first link that it moves, at rest in that link.
struct HandJoint {
  int coordinate = -1;
  int link = -1;                  // the link next to the base of those that the coordinate moves
  Eigen::Vector3d axis{0, 0, 1};  // unit, the link's frame: the hand's at the reference posture (3)
  Eigen::Vector3d point{0, 0, 0};  // on the axis, nearest to the link's surface, same frame [m] (3)
  bool slides = false;             // false: it turns, by the right hand about the axis
};

/// Axes of all coordinates that move a link, found from Jacobians. With the angular column w and
/// the linear column v at a point p, both of the base,
///   axis = w / |w|,  point = p + w x v / |w|^2,  or axis = v / |v| where w is zero: it slides.
/// @throws InputError if a coordinate turns and slides its first link at once.
[[nodiscard]] std::vector<HandJoint> hand_joints(const Hand& hand);

/// A joint that follows another one while nothing touches.
struct JointLead {
  int leader = -1;   // coordinate; -1: none
  double ratio = 0;  // of the motions, this one's by the leader's [rad/rad], [m/m], ..
};

/// Finds the leader of each coordinate of a robot: the first coordinate of its drive leads the
/// others, in the ratio of their gears. A digit that tendons pull has no leader: its joints are
/// moved one by one.
/// @return  (coordinates)
[[nodiscard]] std::vector<JointLead> joint_leads(const Hand& hand);

}  // namespace thenar
