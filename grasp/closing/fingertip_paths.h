#pragma once

/// Paths of the fingertips when a hand closes on nothing.

#include <vector>

#include "hand/hand.h"

namespace thenar {

/// Positions of the tips at a posture, hand frame [m] (3, tips)
[[nodiscard]] Eigen::Matrix3Xd fingertip_positions(const Hand& hand, const Eigen::VectorXd& q);

/// Paths of the tips from a posture until every driven coordinate is at its limit, each at its own
/// speed and without contact, at equal times; hand frame.
struct FingertipPaths {
  std::vector<Eigen::Matrix3Xd> tips;  // at each time, the first at the start [m] (3, tips)
  Eigen::Vector3d axis;                // closing_axis(), unit (3)
};
/// Computes the paths of the tips. @param q  posture at the start (coordinates)
[[nodiscard]] FingertipPaths fingertip_paths(const Hand& hand, const Eigen::VectorXd& q);

/// Unit direction c across the approach d along which the tips come together. It maximises
///   sum over tips of  (c' v)^2,  v = motion of the tip in the first half of closing;
/// any direction across the approach if no tip moves across it. Its sign is arbitrary. (3)
[[nodiscard]] Eigen::Vector3d closing_axis(const std::vector<Eigen::Matrix3Xd>& tips,
                                           const Eigen::Vector3d& approach);

/// Mean distance of the tips ahead of the point of approach, at the first time at which they are no
/// farther apart along the closing axis than `width`, or as near as they come [m]; of an only tip,
/// where it is closed; -infinity for a hand without tips.
[[nodiscard]] double tips_ahead(const FingertipPaths& ways, const PalmApproach& approach,
                                double width);

}  // namespace thenar
