#pragma once

/// Short descriptions of a grasp: how far it got, what overlaps, where a wrench or a motion points.

#include <string>
#include <vector>

#include "grasp/closing/grasp.h"

namespace thenar {

/// The large parts of a wrench: "force along -z, torque about +x". Parts below a third of the
/// largest are left out; "none" of a zero wrench.
[[nodiscard]] std::string direction_words(const ScaledWrench& wrench);

/// Returns the large parts of a motion: "along -z, turning about +x".
[[nodiscard]] std::string motion_words(const ScaledMotion& motion);

/// Returns whether two hard points press on each other within friction: they resist every load but
/// a torque about the line through them (both friction cones have this line: Nguyen's condition).
[[nodiscard]] bool is_held_between_two(const std::vector<HandContact>& contacts);

/// "grasped: 12 contacts, force closure", "the hand begins in something: DP2 is 3.2 mm in table"..
[[nodiscard]] std::string outcome_words(const Grasp& grasp);

/// "DP2 is 3.2 mm in table, ..."
[[nodiscard]] std::string overlap_words(const std::vector<Overlap>& overlaps);

/// A warning about links of the hand that begin in each other, so that they do not stop each other;
/// empty where none do.
[[nodiscard]] std::string own_overlap_words(const ClosedHand& closed);

/// Returns whether a coordinate slides rather than turns.
/// @param q  where it is looked at (coordinates)
[[nodiscard]] bool slides(const Hand& hand, const Eigen::VectorXd& q, int coordinate);

}  // namespace thenar
