#include "apps/pose_report.h"

#include <set>

#include <fmt/format.h>

namespace thenar {
namespace {

std::vector<JointNow> joints_now(const Skeleton& skeleton, const TreeState<double>& state,
                                 const Eigen::VectorXd& q) {
  std::vector<JointNow> joints;
  for (std::size_t i = 0; i < skeleton.tree.size(); ++i) {
    const Hinge<double>& hinge = skeleton.tree[i];
    const std::string& name = skeleton.hinge_names[i];
    const std::string& leader =
        skeleton.coordinate_names[static_cast<std::size_t>(hinge.coordinate)];
    joints.push_back({name, hinge.ratio * q[hinge.coordinate] + hinge.offset, state[i].axis,
                      state[i].point, leader == name ? "" : leader});
  }
  return joints;
}

std::vector<SegmentNow> segments_now(const Subject& subject, const Skeleton& skeleton,
                                     const TreeState<double>& state) {
  std::vector<SegmentNow> segments;
  for (const Segment& segment : subject.segments) {
    const auto link = skeleton.link_of_segment.find(segment.name);
    if (link == skeleton.link_of_segment.end()) continue;
    // Frozen joints displace a segment before any hinge of its link turns.
    const Pose<double>& at = skeleton.segment_at.at(segment.name);
    const Pose<double> X =
        link->second < 0 ? at : state[static_cast<std::size_t>(link->second)].X * at;
    segments.push_back({segment.name, X, X * segment.proximal, X * segment.distal});
  }
  return segments;
}

/// The coordinates between the tip and the base, in order.
std::set<int> coordinates_of(const Skeleton& skeleton, const SkeletonTip& tip) {
  std::set<int> coordinates;
  for_each_hinge_to_base(skeleton.tree, tip.link, [&](int i) {
    coordinates.insert(skeleton.tree[static_cast<std::size_t>(i)].coordinate);
  });
  return coordinates;
}

TipNow tip_now(const Skeleton& skeleton, const TreeState<double>& state, const SkeletonTip& tip) {
  TipNow now{tip.digit, moved(state, tip.link, tip.p), tip.axes, {}, {}, {}};
  if (tip.link >= 0) now.axes = state[static_cast<std::size_t>(tip.link)].X.R * tip.axes;
  const Eigen::Matrix3Xd J =
      position_jacobian(skeleton.tree, state, tip.link, now.p, skeleton.coordinates());
  const std::set<int> coordinates = coordinates_of(skeleton, tip);
  now.J.resize(3, static_cast<Eigen::Index>(coordinates.size()));
  for (const int c : coordinates) {
    now.J.col(static_cast<Eigen::Index>(now.joints.size())) = J.col(c);
    now.joints.push_back(skeleton.coordinate_names[static_cast<std::size_t>(c)]);
  }
  if (!now.joints.empty()) now.mobility = tip_manipulability(now.J);
  return now;
}

std::string direction(const Eigen::Vector3d& d) {
  // A direction has no sense here: the largest component is shown positive.
  Eigen::Index largest = 0;
  d.cwiseAbs().maxCoeff(&largest);
  const Eigen::Vector3d shown = (d[largest] < 0 ? Eigen::Vector3d(-d) : d).array() + 0.0;
  const auto round = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; };
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", round(shown.x()), round(shown.y()),
                     round(shown.z()));
}

}  // namespace

PoseReport pose_report(const Subject& subject, const Skeleton& skeleton, const Eigen::VectorXd& q) {
  const TreeState<double> state = pose_tree(skeleton.tree, q);
  PoseReport report{
      subject.name, joints_now(skeleton, state, q), segments_now(subject, skeleton, state), {}};
  for (const SkeletonTip& tip : skeleton.tips) report.tips.push_back(tip_now(skeleton, state, tip));
  return report;
}

std::string mobility_in_words(const TipNow& tip) {
  constexpr double kNearlySingular = 100;  // of the condition number
  if (tip.joints.empty()) return "fixed: every joint between wrist and tip is frozen";
  const TipManipulability& can = tip.mobility;
  if (can.rank == 3 && can.condition < kNearlySingular)
    return fmt::format("regular: condition {:.3g}; moves least along {}", can.condition,
                       direction(can.directions.col(2)));
  if (can.rank == 3)
    return fmt::format("nearly singular: condition {:.3g}; hardly moves along {}", can.condition,
                       direction(can.directions.col(2)));
  std::string blocked;
  for (int k = can.rank; k < 3; ++k)
    blocked += (blocked.empty() ? "" : " nor ") + direction(can.directions.col(k));
  return fmt::format("singular: cannot move along {}, and carries any force there without tendons",
                     blocked);
}

}  // namespace thenar
