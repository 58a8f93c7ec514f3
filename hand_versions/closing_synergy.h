#pragma once

/// Closing synergies of a human hand, and the approach direction of its palm.

#include "data/io/subject.h"
#include "hand/skeleton_hand.h"
#include "hand/skin/hand_anatomy.h"

namespace thenar {

/// Builds one drive for each digit, of all its flexion joints, and one of speed 0 for every other
/// joint.
///
/// Speeds are a convention: MCP : PIP : DIP as 1 : 1 : 2/3, so that the fingertip curls into the
/// palm, at 1 rad/s; CMC : MCP : IP of the thumb as 1 : 1 : 1, at 1/4 rad/s, so that it closes over
/// the fingers of a fist, not under them. A blocked phalanx lets the more distal ones continue, as
/// with independent muscles. The hand approaches palm first. Its open posture has closing joints at
/// zero, or at the nearest limit, and other joints in the middle of their ranges: fingers not
/// spread, the thumb half abducted in opposition.
[[nodiscard]] ClosingSynergy motor_synergy(const HandAnatomy& hand, const Subject& subject,
                                           const Skeleton& skeleton);

/// Returns the tensions of a closing hand: the upper bounds for flexors (FDS and FDP, or FPL), 0
/// for other muscles. tendon_rates() of grasp/closing/tendon_closing.h closes a hand by them
/// posture by posture.
/// @return (actuators) [N]
/// @throws InputError unless every actuator has a name.
[[nodiscard]] Eigen::VectorXd max_flexor_tensions(const std::vector<std::string>& actuators,
                                                  const Actuation& actuation);

/// Returns these tensions at the hand's zero posture, or at its nearest limits.
[[nodiscard]] Eigen::VectorXd max_flexor_tensions(const Hand& hand);

/// Builds drives that close by tendon excursion: the flexors (FDS and FDP, or FPL) pull with
/// tensions in the ratio of their largest ones. Joints of equal stiffness k then turn by dq = B t /
/// k,  in the ratio of their torques; the fastest joint of a finger at 1 rad/s, of the thumb at
/// 1/4. Equal stiffness is an assumption, as most subjects state none. When a joint is blocked the
/// tendon continues to move all others. Digits without these muscles close as with motors.
/// @param actuation  actuation of the hand at the reference posture; its actuators have these names
[[nodiscard]] ClosingSynergy tendon_synergy(const HandAnatomy& hand, const Subject& subject,
                                            const Skeleton& skeleton,
                                            const std::vector<std::string>& actuators,
                                            const Actuation& actuation);

}  // namespace thenar
