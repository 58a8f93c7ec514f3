#include "grasp/closing/fingertip_paths.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "base/numbers.h"
#include "grasp/closing/closing_drives.h"

namespace thenar {
namespace {

constexpr int kClosingIntervals = 20;  // Intervals into which closing is divided
}  // namespace

Eigen::Matrix3Xd fingertip_positions(const Hand& hand, const Eigen::VectorXd& q) {
  const std::vector<HandTip>& tips = hand.layout().tip_points;
  const std::vector<Pose<double>> links = hand.pose(q);
  Eigen::Matrix3Xd at(3, static_cast<Eigen::Index>(tips.size()));
  // Each tip on its link; tips on the base do not move.
  for (Eigen::Index t = 0; t < at.cols(); ++t) {
    const HandTip& tip = tips[static_cast<std::size_t>(t)];
    at.col(t) = tip.link < 0 ? tip.p : links[static_cast<std::size_t>(tip.link)] * tip.p;
  }
  return at;
}

FingertipPaths fingertip_paths(const Hand& hand, const Eigen::VectorXd& q) {
  const HandLayout& layout = hand.layout();
  const Eigen::VectorXd rates = ClosingDrives(layout).rates();
  const double whole = time_to_limits(layout, q, rates);
  // Positions at equal times; coordinates stay at their limits.
  FingertipPaths ways;
  for (int i = 0; i <= kClosingIntervals; ++i)
    ways.tips.push_back(fingertip_positions(
        hand,
        (q + i * whole / kClosingIntervals * rates).cwiseMax(layout.lower).cwiseMin(layout.upper)));
  ways.axis = closing_axis(ways.tips, layout.approach.direction);
  return ways;
}

Eigen::Vector3d closing_axis(const std::vector<Eigen::Matrix3Xd>& tips,
                             const Eigen::Vector3d& approach) {
  // Motion of the tips in the first half of closing, across the approach.
  const Tangents across = tangents(approach);
  Eigen::Matrix<double, 2, 3> plane;
  plane << across.e1.transpose(), across.e2.transpose();
  const Eigen::Matrix2Xd way = plane * (tips[tips.size() / 2] - tips.front());
  // Main direction of these motions.
  const Eigen::Matrix2d spread = way * way.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  return (plane.transpose() * axes.eigenvectors().col(1)).normalized();
}

double tips_ahead(const FingertipPaths& ways, const PalmApproach& approach, double width) {
  double least = kInfinity, ahead = -kInfinity;
  // An only tip closes on what is fixed.
  if (ways.tips.back().cols() == 1)
    return approach.direction.dot(ways.tips.back().col(0) - approach.point);
  // The tips come together until they are as near as the width.
  for (const Eigen::Matrix3Xd& tips : ways.tips) {
    if (tips.cols() == 0) continue;
    const Eigen::RowVectorXd along = ways.axis.transpose() * tips;
    const double apart = along.maxCoeff() - along.minCoeff();
    if (apart >= least) continue;
    least = apart;
    ahead = approach.direction.dot(tips.rowwise().mean() - approach.point);
    if (apart <= width) break;  // tips that pass each other part again
  }
  return ahead;
}

}  // namespace thenar
