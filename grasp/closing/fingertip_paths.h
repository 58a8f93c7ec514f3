#pragma once

/// Paths of the fingertips of a hand that closes without an object.

#include <vector>

#include "hand/hand.h"

namespace thenar {

/// Returns the position of a point of a link, in the hand's frame [m] (3).
/// @param links  Hand::pose();  @param link  -1: the base;  @param p  in the reference posture [m]
[[nodiscard]] inline Eigen::Vector3d moved_with(const std::vector<Pose<double>>& links, int link,
                                                const Eigen::Vector3d& p) {
  return link < 0 ? p : Eigen::Vector3d(links[link] * p);
}

/// Returns the positions of the tips at a posture, hand frame [m] (3, tips)
[[nodiscard]] Eigen::Matrix3Xd fingertip_positions(const Hand& hand, const Eigen::VectorXd& q);

/// Paths of the tips from a posture until every driven coordinate is at its limit, without contact,
/// sampled at equal times; hand frame.
struct FingertipPaths {
  std::vector<Eigen::Matrix3Xd> tips;  // positions at each time, first the start [m] (3, tips)
  Eigen::Vector3d axis{0, 0, 0};       // closing_axis(), unit (3)
};
/// Computes the paths of the tips. @param q  initial posture (coordinates)
[[nodiscard]] FingertipPaths fingertip_paths(const Hand& hand, const Eigen::VectorXd& q);

/// Returns the unit direction c across the approach d along which the tips converge. It maximises
///   sum over tips of  (c' v)^2,  v = motion of the tip in the first half of closing;
/// if no tip moves across the approach, it is any direction across it. Its sign is arbitrary. (3)
[[nodiscard]] Eigen::Vector3d closing_axis(const std::vector<Eigen::Matrix3Xd>& tips,
                                           const Eigen::Vector3d& approach);

/// Returns the mean distance of the tips ahead of the point of approach [m], at the first time at
/// which their extent along the closing axis is at most `width`, or smallest. For a single tip it
/// is the distance when closed; for a hand without tips, -infinity.
[[nodiscard]] double mean_tip_advance(const FingertipPaths& paths, const PalmApproach& approach,
                                      double width);

}  // namespace thenar
