#include "api/pose.h"

#include <filesystem>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "api/named/data_folders.h"
#include "api/named/digits.h"
#include "api/named/files.h"
#include "api/named/hands.h"
#include "base/error.h"
#include "base/file_io.h"
#include "data/io/file_kind.h"
#include "data/io/robot/import_robot.h"

namespace thenar {
namespace {

/// Returns the file of the robot given by a name or a file; absent: the model is a subject.
std::optional<std::string> robot_of(const PoseRequest& request) {
  if (!is_file(request.model)) return robot_file(request.model, data_folders(request.data));
  require_kind(request.model, {"subject", "robot"});
  const bool subject = std::filesystem::path(request.model).extension() == ".toml" &&
                       find_file_kind(request.model) != FileKind::kRobot;
  return subject ? std::nullopt : std::optional(request.model);
}

std::vector<JointPose> joints_now(const Skeleton& skeleton, const TreeState<double>& state,
                                  const Eigen::VectorXd& q) {
  // A joint that follows another one turns by ratio q + offset of its leader.
  std::vector<JointPose> joints;
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

std::vector<SegmentPose> segments_now(const Subject& subject, const Skeleton& skeleton,
                                      const TreeState<double>& state) {
  // Skip segments that the tree leaves out, as those of other digits.
  std::vector<SegmentPose> segments;
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

TipPose tip_now(const Skeleton& skeleton, const TreeState<double>& state, const SkeletonTip& tip) {
  TipPose now{tip.digit, moved(state, tip.link, tip.p), tip.axes, {}, {}, {}};
  if (tip.link >= 0) now.axes = state[static_cast<std::size_t>(tip.link)].X.R * tip.axes;
  // Keep the columns of the joints that move this tip; all others are zero.
  const Eigen::Matrix3Xd J =
      position_jacobian(skeleton.tree, state, tip.link, now.p, skeleton.coordinates());
  const std::set<int> coordinates = coordinates_of(skeleton, tip);
  const std::vector<int> columns(coordinates.begin(), coordinates.end());
  now.J = J(Eigen::all, columns);
  for (const int c : columns)
    now.joints.push_back(skeleton.coordinate_names[static_cast<std::size_t>(c)]);
  if (columns.empty()) return now;
  const Eigen::Matrix3Xd W =
      rotation_jacobian(skeleton.tree, state, tip.link, skeleton.coordinates());
  now.mobility = tip_manipulability(now.J, Eigen::Matrix3Xd(W(Eigen::all, columns)));
  return now;
}

SubjectPoses pose_subject(const PoseRequest& request, const Progress& progress) {
  // Maps alone have no joints to pose.
  const SourceText source = subject_source(request.model, request.data, "model");
  const Subject subject = parse_subject(source.text, source.path);
  require_field(
      "model", !subject.joints.empty(),
      "subject '{}' has no joints to pose, only maps from tendon tensions to tip forces; ask "
      "tip-force or feasible-force",
      subject.name);
  const Skeleton skeleton = in_field("digits", [&] {
    return build_skeleton(subject, {request.digits, frozen_joints(subject, request.frozen)});
  });
  SubjectPoses poses;
  // Pose every posture of the grid, in the order in which the angles vary.
  poses.request = request;
  poses.subject = subject.name;
  poses.coordinates = skeleton.coordinate_names;
  poses.grid = posture_grid(skeleton, request.posture, request.vary);
  poses.sources = {source};
  poses.outcome.warnings = poses.grid.warnings;
  const std::size_t count = poses.grid.postures.size();
  for (std::size_t i = 0; i < count && !progress.stop(); ++i) {
    poses.points.push_back(pose_of(subject, skeleton, poses.grid.postures[i]));
    progress(static_cast<double>(i + 1) / static_cast<double>(count),
             fmt::format("posture {} of {}", i + 1, count));
  }
  poses.outcome.count_parts(poses.points.size(), count, "posture");
  return poses;
}

}  // namespace

SubjectPose pose_of(const Subject& subject, const Skeleton& skeleton, const Eigen::VectorXd& q) {
  const TreeState<double> state = pose_tree(skeleton.tree, q);
  SubjectPose pose{q, joints_now(skeleton, state, q), segments_now(subject, skeleton, state), {}};
  for (const SkeletonTip& tip : skeleton.tips) pose.tips.push_back(tip_now(skeleton, state, tip));
  return pose;
}

PoseResult compute_poses(const PoseRequest& request, const Progress& progress) {
  const std::optional<std::string> robot = in_field("model", [&] { return robot_of(request); });
  if (!robot) return pose_subject(request, progress);
  require_field(request.frozen.empty() ? "digits" : "frozen",
                request.digits.empty() && request.frozen.empty(),
                "digits and frozen joints are for subjects, '{}' is a robot", *robot);
  return pose_robot(import_robot(*robot), request, progress);
}

}  // namespace thenar
