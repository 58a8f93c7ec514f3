#include "api/robot_pose.h"

#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "data/io/robot/link_poses.h"
#include "grasp/robot/infer_hand.h"
#include "grasp/robot/robot_tips.h"

namespace thenar {
namespace {

constexpr std::size_t kMaxWarnings = 20;  // largest number of warnings for a grid [1]
constexpr double kSameValue = 1e-9;       // largest difference of equal values [rad] or [m]

/// [rad] or [m] in a unit of a request.
double drive_unit(bool sliding, PostureUnit unit) {
  if (unit == PostureUnit::kSI) return 1;
  return sliding ? kMm : kDegree;
}

/// Returns the moving joint of a name.
/// @param field  field of the request that has the name
/// @throws InputError listing the degrees of freedom and moving joints
const RobotJoint& moving_joint(const RobotSpec& robot, const std::string& name, const char* field) {
  std::vector<std::string> known = names_of(robot.dofs);
  for (const RobotJoint& joint : robot.joints) {
    if (joint.kind == RobotJointKind::kFixed) continue;
    known.push_back(joint.name);
    if (joint.name == name) return joint;
  }
  throw InputError(
      fmt::format("robot '{}' has no degree of freedom or moving joint '{}'{} it has {}",
                  robot.name, name, hint_before_list(name, known), listed(known)),
      field);
}

/// Returns true if the degree of freedom or joint of a name slides. @throws as moving_joint()
bool drive_slides(const RobotSpec& robot, const std::string& name) {
  if (const RobotDof* dof = find_named(robot.dofs, name)) return slides(robot, *dof);
  return slides(moving_joint(robot, name, "vary"));
}

/// Values by names of degrees of freedom and joints, in the unit of the request.
std::map<std::string, double> values_of(const RobotSpec& robot, const PostureRequest& posture) {
  if (posture.in_order.empty()) return posture.named;
  const std::vector<std::string> names = names_of(robot.dofs);
  require_field("posture", posture.in_order.size() == names.size(),
                "wanted {} values [{}], of {}, got {}", names.size(),
                posture.unit == PostureUnit::kTyped ? "deg or mm" : "rad or m", listed(names),
                posture.in_order.size());
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < names.size(); ++i) values[names[i]] = posture.in_order[i];
  return values;
}

/// Computes the position of a rigid motor from the value of its joint, by bisection between the
/// motor's limits if the joint follows a curve.
double motor_of(const RobotJoint& joint, const RobotDof& dof, double value) {
  if (joint.curve.empty()) return (value - joint.offset) / joint.ratio;
  // A curve rises or falls between the limits, so that bisection finds the motor.
  double a = dof.lower, b = dof.upper;
  const bool rises = joint_value(joint, b) > joint_value(joint, a);
  for (int i = 0; i < 60; ++i) {
    const double middle = (a + b) / 2;
    ((joint_value(joint, middle) < value) == rises ? a : b) = middle;
  }
  require_field(
      "posture", std::abs(joint_value(joint, a) - value) < 1e-6,
      "joint '{}' does not come to {:.6g} (rad or m) along the curve on which it follows '{}'",
      joint.name, value, dof.name);
  return a;
}

/// Values of all joints.
class RobotPosture {
 public:
  /// @param values  by names of degrees of freedom and joints, in the unit of `posture`
  RobotPosture(const RobotSpec& robot, const std::map<std::string, double>& values,
               PostureUnit unit)
      : robot_(robot), unit_(unit) {
    for (const auto& [name, value] : values) set(name, value);
  }

  [[nodiscard]] double value(const RobotJoint& joint) const {
    if (const auto own = joints_.find(joint.name); own != joints_.end()) return own->second;
    return joint_value(joint, dofs_);
  }

 private:
  void set(const std::string& name, double value) {
    // A name is a degree of freedom, or else a joint that one of them moves.
    if (const RobotDof* dof = find_named(robot_.dofs, name)) {
      move(*dof, value * drive_unit(slides(robot_, *dof), unit_));
      return;
    }
    const RobotJoint& joint = moving_joint(robot_, name, "posture");
    set(joint, value * drive_unit(slides(joint), unit_));
  }

  void set(const RobotJoint& joint, double value) {
    const RobotDof* dof = find_named(robot_.dofs, joint.dof);
    if (dof == nullptr || dof->kind != DriveCoupling::kRigid)
      joints_[joint.name] = value;  // may differ from the other joints of its motor
    else
      move(*dof, motor_of(joint, *dof, value));
  }

  void move(const RobotDof& dof, double value) {
    const auto [at, is_new] = dofs_.emplace(dof.name, value);
    require_field(
        "posture", is_new || std::abs(at->second - value) < kSameValue,
        "'{}' cannot be at {:.6g} and at {:.6g} (rad or m) at once: joints of one motor move "
        "together",
        dof.name, at->second, value);
  }

  const RobotSpec& robot_;
  PostureUnit unit_;
  DofValues dofs_;
  std::map<std::string, double> joints_;
};

/// Returns the robot with every joint held at its value.
RobotSpec held(RobotSpec robot, const RobotPosture& posture) {
  for (RobotJoint& joint : robot.joints) {
    if (joint.kind == RobotJointKind::kFixed) continue;
    joint.offset = posture.value(joint);
    joint.dof.clear();
    joint.curve.clear();
  }
  return robot;
}

void warn_of_limits(const RobotJoint& joint, double value, std::vector<std::string>& warnings) {
  if (value >= joint.lower - kSameValue && value <= joint.upper + kSameValue) return;
  const double unit = drive_unit(slides(joint), PostureUnit::kTyped);
  warnings.push_back(fmt::format("joint '{}' at {:.4g} is outside {:.4g} .. {:.4g} {}", joint.name,
                                 value / unit, joint.lower / unit, joint.upper / unit,
                                 slides(joint) ? "mm" : "deg"));
}

/// The link that carries each one; -1: none.
std::vector<int> parents_of(const RobotSpec& robot) {
  std::vector<int> parents(robot.links.size(), -1);
  for (const RobotJoint& joint : robot.joints)
    parents[static_cast<std::size_t>(place_named(robot.links, joint.child))] =
        place_named(robot.links, joint.parent);
  return parents;
}

RobotPose robot_at(const RobotSpec& robot, const RobotPosture& posture) {
  // Place every link by forward kinematics, in the frame of the base.
  RobotSpec at = held(robot, posture);
  const std::vector<Pose<double>> X = link_poses(at, {});
  const std::vector<int> parents = parents_of(robot);
  RobotPose pose;
  std::map<std::string, Pose<double>> placed;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    placed[robot.links[i].name] = X[i];
    pose.links.push_back({robot.links[i].name, parents[i], X[i]});
  }
  // State each joint's axis and place in the base frame.
  for (const RobotJoint& joint : robot.joints) {
    if (joint.kind == RobotJointKind::kFixed) continue;
    const Pose<double> X_BJ = placed.at(joint.parent) * joint.X_PJ;
    const double value = posture.value(joint);
    pose.joints.push_back(
        {joint.name, joint.dof, slides(joint), value, X_BJ.R * joint.axis, X_BJ.p});
    warn_of_limits(joint, value, pose.warnings);
  }
  // Tips need digits, which are guessed where the file names none.
  if (all_of(at.links, [](const RobotLink& link) { return link.digit.empty(); }))
    (void)infer_digits(at);
  for (const RobotTip& tip : find_tips(at, X))
    pose.tips.push_back({tip.digit, at.links[static_cast<std::size_t>(tip.link)].name, tip.p});
  return pose;
}

/// Every posture of the grid: its values by name, in the unit of the request.
std::vector<std::map<std::string, double>> value_grid(const std::map<std::string, double>& values,
                                                      const std::vector<Vary>& vary) {
  // Start with the posture itself; the last drive varies fastest.
  std::vector<std::map<std::string, double>> grid{values};
  for (const Vary& each : vary) {
    const std::vector<double> steps = steps_of(each, "");
    require_field("vary", grid.size() * steps.size() <= kMaxPostures, "more than {} postures",
                  kMaxPostures);
    std::vector<std::map<std::string, double>> wider;
    for (const auto& before : grid)
      for (const double step : steps) {
        wider.push_back(before);
        wider.back()[each.joint] = step;
      }
    grid = std::move(wider);
  }
  return grid;
}

}  // namespace

RobotPoses pose_robot(const RobotSpec& robot, const PoseRequest& request,
                      const Progress& progress) {
  const PostureRequest& posture = request.posture;
  const std::vector<Vary>& vary = request.vary;
  // Each drive varies once, in radians or metres.
  RobotPoses poses;
  poses.request = request;
  poses.robot = robot.name;
  poses.files = robot.files;
  for (const Vary& each : vary) {
    for (const VariedDrive& before : poses.varied)
      require_field("vary", before.name != each.joint, "'{}' varies twice", each.joint);
    poses.varied.push_back({each.joint, drive_slides(robot, each.joint)});
  }
  const auto grid = value_grid(values_of(robot, posture), vary);
  std::vector<std::string>& warnings = poses.outcome.warnings;
  if (!vary.empty()) poses.row = steps_of(vary.back(), "").size();

  for (std::size_t i = 0; i < grid.size() && !progress.stop(); ++i) {
    poses.points.push_back(robot_at(robot, {robot, grid[i], posture.unit}));
    RobotPose& pose = poses.points.back();
    for (const VariedDrive& drive : poses.varied)
      pose.varied.push_back(drive_unit(drive.slides, posture.unit) * grid[i].at(drive.name));
    for (const std::string& warning : pose.warnings)
      if (warnings.size() < kMaxWarnings && !contains(warnings, warning))
        warnings.push_back(warning);
    progress(static_cast<double>(i + 1) / static_cast<double>(grid.size()),
             fmt::format("posture {} of {}", i + 1, grid.size()));
  }
  poses.outcome.count_parts(poses.points.size(), grid.size(), "posture");
  return poses;
}

}  // namespace thenar
