#pragma once

/// What the tendons of a hand could do at each joint alone: limits for a hand of motors.

#include "hand/skeleton_hand.h"
#include "tendons/human/tendon_hand.h"

namespace thenar {

/// The largest and least torque of each coordinate at posture q,
///   upper_j = sum_i max(B_ji, 0) upper_i,   lower_j = sum_i min(B_ji, 0) upper_i.
/// It is the least box about the torques that the tendons make, passive torque aside: a hand of
/// motors with these limits can do at least as much, as its joints do not share muscles.
/// @param tendons  a hand whose least tensions are 0
[[nodiscard]] TorqueLimits joint_strength(const Hand& tendons, const Eigen::VectorXd& q);

}  // namespace thenar
