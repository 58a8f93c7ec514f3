#include <algorithm>
#include <set>

#include "base/error.h"
#include "data/io/robot/robot.h"

namespace thenar {
namespace {

template <typename Part>
std::set<std::string> names_in(const std::vector<Part>& parts) {
  std::set<std::string> names;
  for (const Part& part : parts) names.insert(part.name);
  return names;
}

std::set<std::string> digits_in(const RobotSpec& robot) {
  std::set<std::string> digits;
  for (const RobotLink& link : robot.links)
    if (!link.digit.empty()) digits.insert(link.digit);
  return digits;
}

/// New names for parts whose names are taken.
class Renaming {
 public:
  Renaming(std::set<std::string> taken, std::string prefix)
      : taken_(std::move(taken)), prefix_(std::move(prefix)) {}

  [[nodiscard]] std::string operator()(const std::string& name) const {
    return taken_.count(name) == 1 ? prefix_ + name : name;
  }

 private:
  std::set<std::string> taken_;
  std::string prefix_;
};

/// The fixed joint between carrier and tool.
RobotJoint mount(const std::string& name, const std::string& link, const std::string& base,
                 const Pose<double>& X_LT) {
  RobotJoint joint;
  joint.name = name + " mount";
  joint.kind = RobotJointKind::kFixed;
  joint.parent = link;
  joint.child = base;
  joint.X_PJ = X_LT;
  return joint;
}

/// Pose of a link in the base link with every joint at its offset.
Pose<double> pose_at_zero(const RobotSpec& robot, std::string link) {
  Pose<double> X;
  for (auto joint = robot.joints.rbegin(); joint != robot.joints.rend(); ++joint) {
    if (joint->child != link) continue;
    Pose<double> motion;
    if (joint->kind == RobotJointKind::kRevolute)
      motion.R = rotation_about(joint->axis, joint->offset);
    if (joint->kind == RobotJointKind::kPrismatic) motion.p = joint->offset * joint->axis;
    X = joint->X_PJ * motion * joint->X_JC * X;
    link = joint->parent;
  }
  return X;
}

std::string joined(const std::string& a, const std::string& b) {
  if (a.empty() || a == b) return b;
  return b.empty() ? a : a + ", " + b;
}

void add_renamed(RobotSpec& robot, const RobotSpec& tool) {
  const std::string prefix = tool.name + "/";
  const Renaming link_name(names_in(robot.links), prefix);
  const Renaming joint_name(names_in(robot.joints), prefix);
  const Renaming dof_name(names_in(robot.dofs), prefix);
  const Renaming digit_name(digits_in(robot), prefix);
  for (RobotLink link : tool.links) {
    link.name = link_name(link.name);
    link.digit = digit_name(link.digit);
    robot.links.push_back(std::move(link));
  }
  for (RobotJoint joint : tool.joints) {
    joint.name = joint_name(joint.name);
    joint.parent = link_name(joint.parent);
    joint.child = link_name(joint.child);
    joint.dof = dof_name(joint.dof);
    robot.joints.push_back(std::move(joint));
  }
  for (const auto& [a, b] : tool.joined) robot.joined.emplace_back(link_name(a), link_name(b));
  for (RobotDof dof : tool.dofs) {
    dof.name = dof_name(dof.name);
    robot.dofs.push_back(std::move(dof));
  }
}

}  // namespace

RobotSpec attach(const RobotSpec& carrier, const std::string& link, const RobotSpec& tool,
                 const Pose<double>& X_LT) {
  check_robot(carrier);
  check_robot(tool);
  const std::set<std::string> links = names_in(carrier.links);
  require(links.count(link) == 1, "robot '{}' has no link '{}' to mount '{}' on; it has {}",
          carrier.name, link, tool.name, fmt::join(links, ", "));

  RobotSpec robot = carrier;
  if (!carrier.closing_stated)
    for (RobotDof& dof : robot.dofs) dof.speed = 0;
  robot.closing_stated = tool.closing_stated;
  robot.name = carrier.name + " with " + tool.name;
  robot.source = joined(carrier.source, tool.source);
  robot.licence = joined(carrier.licence, tool.licence);
  const std::string base = Renaming(links, tool.name + "/")(tool.links.front().name);
  robot.joints.push_back(mount(tool.name, link, base, X_LT));
  add_renamed(robot, tool);

  const Pose<double> X_BT = pose_at_zero(carrier, link) * X_LT;
  robot.approach = {X_BT * tool.approach.point, (X_BT.R * tool.approach.direction).normalized()};
  robot.approach_stated = tool.approach_stated;
  robot.open_loops.insert(robot.open_loops.end(), tool.open_loops.begin(), tool.open_loops.end());
  robot.warnings.insert(robot.warnings.end(), tool.warnings.begin(), tool.warnings.end());
  check_robot(robot);
  return robot;
}

}  // namespace thenar
