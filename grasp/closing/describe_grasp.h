#pragma once

/// Short descriptions of a grasp: its outcome, overlaps, and directions of wrenches and motions.

#include <string>
#include <vector>

#include "grasp/closing/grasp.h"

namespace thenar {

/// Returns the large components of a wrench: "force along -z, torque about +x"; components below
/// 1/3 of the largest are left out, and a zero wrench is "none".
[[nodiscard]] std::string direction_words(const ScaledWrench& wrench);

/// Returns the large components of a motion: "along -z, turning about +x".
[[nodiscard]] std::string describe_motion(const ScaledMotion& motion);

/// Returns whether two hard points press on each other within friction, so that they resist every
/// load but a torque about the line through them: both friction cones contain this line (Nguyen's
/// condition).
[[nodiscard]] bool is_held_between_two(const std::vector<HandContact>& contacts);

/// Returns the outcome in words: "grasped: 12 contacts, force closure", "the hand begins in
/// something: DP2 is 3.2 mm in table", ..
[[nodiscard]] std::string describe_outcome(const Grasp& grasp);

/// Returns a list of overlaps: "DP2 is 3.2 mm in table, ..."
[[nodiscard]] std::string describe_overlaps(const std::vector<Overlap>& overlaps);

/// Returns a warning about links that overlap each other at the start, between which contact is
/// ignored; empty if there are none.
[[nodiscard]] std::string describe_self_overlaps(const ClosedHand& closed);

/// Returns whether a coordinate translates rather than rotates.
/// @param q  posture of the test (coordinates)
[[nodiscard]] bool slides(const Hand& hand, const Eigen::VectorXd& q, int coordinate);

}  // namespace thenar
