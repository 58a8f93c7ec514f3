#pragma once

/// Where the tips of a hand go when it closes on nothing.

#include <vector>

#include "hand/hand.h"

namespace thenar {

/// The tips at a posture, hand frame [m] (3, tips)
[[nodiscard]] Eigen::Matrix3Xd fingertip_positions(const Hand& hand, const Eigen::VectorXd& q);

/// The tips at equal times from a posture until every coordinate that a drive moves has come to its
/// limit, each at its own speed and nothing in the way; hand frame.
struct FingertipPaths {
  std::vector<Eigen::Matrix3Xd> tips;  // of each time, the first at the start [m] (3, tips)
  Eigen::Vector3d axis;                // along which the hand closes: see closing_axis() (3)
};
[[nodiscard]] FingertipPaths fingertip_paths(const Hand& hand, const Eigen::VectorXd& q);

/// The unit direction c across the approach d along which tips come together: the largest of
///   sum over tips of  (c' v)^2,  v = the way of the tip in the first half of closing.
/// Any direction across, if no tip goes across. Its sense is without meaning. (3)
[[nodiscard]] Eigen::Vector3d closing_axis(const std::vector<Eigen::Matrix3Xd>& tips,
                                           const Eigen::Vector3d& approach);

/// How far the tips are ahead of the point of approach, on average, at the first time at which they
/// are no farther apart along the closing axis than something of this width, or as near as they
/// come [m]. -infinity for a hand without tips.
[[nodiscard]] double tips_ahead(const FingertipPaths& ways, const PalmApproach& approach,
                                double width);

}  // namespace thenar
