#include "hand/skeleton_hand.h"

#include <utility>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

/// Builds the layout of a skeleton with a motor at each coordinate.
HandLayout layout_of(const Skeleton& skeleton) {
  // Copy the coordinates with their limits.
  HandLayout layout;
  layout.coordinates = skeleton.coordinate_names;
  layout.actuators = skeleton.coordinate_names;
  layout.lower.resize(skeleton.coordinates());
  layout.upper.resize(skeleton.coordinates());
  for (int i = 0; i < skeleton.coordinates(); ++i) {
    layout.lower[i] = skeleton.limits[i].lower;
    layout.upper[i] = skeleton.limits[i].upper;
  }
  // Copy tips, and parents of the links.
  for (const SkeletonTip& tip : skeleton.tips) {
    layout.tips.push_back(tip.digit);
    layout.tip_points.push_back({tip.digit, tip.link, tip.p});
  }
  for (const Hinge<double>& hinge : skeleton.tree) layout.parents.push_back(hinge.parent);
  return layout;
}

}  // namespace

SkeletonHand::SkeletonHand(Skeleton skeleton, TorqueLimits limits,
                           std::vector<LinkSurface> surfaces, ClosingSynergy use)
    : skeleton_(std::move(skeleton)),
      limits_(std::move(limits)),
      layout_(layout_of(skeleton_)),
      surfaces_(std::move(surfaces)) {
  const Eigen::Index n = skeleton_.coordinates();
  // Check that limits, drives and open posture fit the skeleton.
  require(limits_.lower.size() == n && limits_.upper.size() == n,
          "{} coordinates want as many torque limits, got {} lower and {} upper", n,
          limits_.lower.size(), limits_.upper.size());
  for (Eigen::Index i = 0; i < n; ++i)
    require(limits_.lower[i] <= limits_.upper[i], "torque limits of joint '{}' cross: {} .. {} N m",
            layout_.coordinates[i], limits_.lower[i], limits_.upper[i]);
  for (const Drive& drive : use.drives)
    for (const DrivenCoordinate& driven : drive.moves)
      require(driven.coordinate >= 0 && driven.coordinate < n,
              "drive '{}' moves coordinate {}; there are {}", drive.name, driven.coordinate, n);
  require(use.open.size() == 0 || use.open.size() == n,
          "the open posture has {} entries for {} coordinates", use.open.size(), n);
  layout_.drives = std::move(use.drives);
  layout_.open = std::move(use.open);
  layout_.approach = use.approach;
}

std::vector<Pose<double>> SkeletonHand::pose(const Eigen::VectorXd& q) const {
  require_posture(q);
  return transformed(pose_tree(skeleton_.tree, q), [](const auto& link) { return link.X; });
}

Eigen::Matrix<double, 6, Eigen::Dynamic> SkeletonHand::jacobian(const Eigen::VectorXd& q, int link,
                                                                const Eigen::Vector3d& p) const {
  require_posture(q);
  const int links = static_cast<int>(skeleton_.tree.size());
  require(link >= -1 && link < links, "no link {}; there are {}", link, links);
  const TreeState<double> state = pose_tree(skeleton_.tree, q);
  return spatial_jacobian(skeleton_.tree, state, link, moved(state, link, p),
                          skeleton_.coordinates());
}

Actuation SkeletonHand::actuation(const Eigen::VectorXd& q) const {
  require_posture(q);
  const Eigen::Index n = skeleton_.coordinates();
  return {Eigen::MatrixXd::Identity(n, n), passive_torque(skeleton_, q), limits_.lower,
          limits_.upper};
}

void SkeletonHand::require_posture(const Eigen::VectorXd& q) const {
  require(q.size() == skeleton_.coordinates(), "the hand has {} coordinates, q has {}",
          skeleton_.coordinates(), q.size());
}

}  // namespace thenar
