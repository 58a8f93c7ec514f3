#include "grasp/closing/fingertip_paths.h"

#include <Eigen/Eigenvalues>

#include "base/numbers.h"
#include "grasp/closing/closing_drives.h"

namespace thenar {
namespace {

constexpr int kClosingIntervals = 20;  // number of time intervals of the paths

}  // namespace

Eigen::Matrix3Xd fingertip_positions(const Hand& hand, const Eigen::VectorXd& q) {
  const std::vector<Pose<double>> links = hand.pose(q);
  return as_columns(hand.layout().tip_points,
                    [&](const HandTip& tip) { return moved_with(links, tip.link, tip.p); });
}

FingertipPaths fingertip_paths(const Hand& hand, const Eigen::VectorXd& q) {
  const HandLayout& layout = hand.layout();
  const Eigen::VectorXd rates = ClosingDrives(layout).rates();
  const double duration = time_to_limits(layout, q, rates);
  // Positions at equal times; coordinates stop at their limits.
  FingertipPaths paths;
  for (int i = 0; i <= kClosingIntervals; ++i)
    paths.tips.push_back(fingertip_positions(hand, (q + i * duration / kClosingIntervals * rates)
                                                       .cwiseMax(layout.lower)
                                                       .cwiseMin(layout.upper)));
  paths.axis = closing_axis(paths.tips, layout.approach.direction);
  return paths;
}

Eigen::Vector3d closing_axis(const std::vector<Eigen::Matrix3Xd>& tips,
                             const Eigen::Vector3d& approach) {
  // Motion of the tips in the first half of closing, across the approach.
  const Tangents across = tangents(approach);
  Eigen::Matrix<double, 2, 3> plane;
  plane << across.e1.transpose(), across.e2.transpose();
  const Eigen::Matrix2Xd motion = plane * (tips[tips.size() / 2] - tips.front());
  // Principal direction of these motions.
  const Eigen::Matrix2d spread = motion * motion.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(Eigen::MatrixXd{spread});
  return (plane.transpose() * axes.eigenvectors().col(1)).normalized();
}

double mean_tip_advance(const FingertipPaths& paths, const PalmApproach& approach, double width) {
  double min_extent = kInfinity, advance = -kInfinity;
  // A single tip closes on a fixed part.
  if (paths.tips.back().cols() == 1)
    return approach.direction.dot(paths.tips.back().col(0) - approach.point);
  // The tips converge until their extent is at most the width.
  for (const Eigen::Matrix3Xd& tips : paths.tips) {
    if (tips.cols() == 0) continue;
    const Eigen::RowVectorXd along = paths.axis.transpose() * tips;
    const double extent = along.maxCoeff() - along.minCoeff();
    if (extent >= min_extent) continue;
    min_extent = extent;
    advance = approach.direction.dot(tips.rowwise().mean() - approach.point);
    if (extent <= width) break;  // tips that pass each other separate again
  }
  return advance;
}

}  // namespace thenar
