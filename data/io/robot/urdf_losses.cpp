#include "data/io/robot/urdf_losses.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/lists.h"
#include "data/io/robot/link_poses.h"

namespace thenar::internal {
namespace {

/// Returns whether a motor moves any joint.
bool has_joint(const RobotSpec& robot, const std::string& dof) {
  return any_of(robot.joints, [&](const RobotJoint& joint) { return joint.dof == dof; });
}

/// Collects warnings, property by property.
class UrdfLosses {
 public:
  explicit UrdfLosses(const RobotSpec& robot) : robot_(robot) {}

  /// Warns of everything that URDF cannot express.
  std::vector<std::string> find() {
    add_links();
    add_motors();
    for (const RobotDof& dof : robot_.dofs)
      if (dof.kind != DriveCoupling::kRigid)
        warnings_.push_back(fmt::format("URDF has no {} couplings: '{}' is written as rigid",
                                        name_in(kDriveCouplingNames, dof.kind), dof.name));
    for (const RobotJoint& joint : robot_.joints)
      if (!joint.curve.empty())
        warnings_.push_back(
            fmt::format("URDF has no curved couplings: that of joint '{}' is written as a line, "
                        "off by up to {:.3g} "
                        "rad or m",
                        joint.name, line_of(robot_, joint).off));
    for (const RobotJoint& joint : robot_.joints)
      if (joint.stiffness != 0)
        warnings_.push_back(
            fmt::format("URDF has no springs: that of joint '{}' is left out", joint.name));
    return std::move(warnings_);
  }

 private:
  /// Warns of a property that URDF cannot express, if any part has it.
  void leave_out(const std::string& what, const std::vector<std::string>& of) {
    if (!of.empty())
      warnings_.push_back(fmt::format("URDF has no {}: left out of {}", what, fmt::join(of, ", ")));
  }

  template <typename Part, typename Has>
  static std::vector<std::string> names_of(const std::vector<Part>& parts, const Has& has) {
    std::vector<std::string> names;
    for (const Part& part : parts)
      if (has(part)) names.push_back(part.name);
    return names;
  }

  void add_links() {
    leave_out("materials of contact",
              names_of(robot_.links, [](const RobotLink& link) { return !link.material.empty(); }));
    leave_out("digits",
              names_of(robot_.links, [](const RobotLink& link) { return !link.digit.empty(); }));
    leave_out("inertia without mass", names_of(robot_.links, [](const RobotLink& link) {
                return !(link.mass > 0) && !link.inertia.isZero(0);
              }));
    const RobotApproach unsaid;
    if (robot_.approach.point != unsaid.point || robot_.approach.direction != unsaid.direction)
      leave_out("approach", {robot_.name});
  }

  void add_motors() {
    leave_out("places where closing begins",
              names_of(robot_.dofs, [](const RobotDof& dof) { return dof.open.has_value(); }));
    for (const std::string& loop : robot_.open_loops)
      warnings_.push_back("URDF has no loops, open as it is: " + loop);
    if (robot_.closing_stated)
      leave_out("direction of closing",
                names_of(robot_.dofs, [](const RobotDof& dof) { return dof.speed != 0; }));
    leave_out("nominal efforts, so that they count as known",
              names_of(robot_.dofs, [](const RobotDof& dof) { return dof.nominal_effort; }));
    leave_out("worms and brakes",
              names_of(robot_.dofs, [](const RobotDof& dof) { return !dof.backdrivable; }));
    for (const RobotDof& dof : robot_.dofs)
      if (!has_joint(robot_, dof.name))
        leave_out("motors without joints", {dof.name});
      else if (leader_of(robot_, dof.name).name != dof.name)
        warnings_.push_back(fmt::format("URDF has no names of motors: '{}' is that of joint '{}'",
                                        dof.name, leader_of(robot_, dof.name).name));
    for (const RobotJoint& joint : robot_.joints)
      if (joint.kind != RobotJointKind::kFixed && joint.dof.empty())
        warnings_.push_back(
            fmt::format("URDF has no joints without motors: '{}' gets one", joint.name));
  }

  const RobotSpec& robot_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> losses_in_urdf(const RobotSpec& robot) { return UrdfLosses(robot).find(); }

const RobotJoint& leader_of(const RobotSpec& robot, const std::string& dof) {
  const RobotJoint* first = nullptr;
  for (const RobotJoint& joint : robot.joints) {
    if (joint.dof != dof) continue;
    if (joint.ratio == 1 && joint.offset == 0 && joint.curve.empty()) return joint;
    if (first == nullptr || (!first->curve.empty() && joint.curve.empty())) first = &joint;
  }
  return *first;
}

CouplingLine line_of(const RobotSpec& robot, const RobotJoint& joint) {
  if (joint.curve.empty()) return {joint.ratio, joint.offset};
  const RobotDof* dof = find_named(robot.dofs, joint.dof);
  // Chord of the curve.
  const double span = dof->upper - dof->lower, at_lower = joint_value(joint, dof->lower);
  const double ratio = span > 0 ? (joint_value(joint, dof->upper) - at_lower) / span : joint.ratio;
  // Range of deviations from the chord.
  double least = 0, most = 0;
  for (int i = 0; i <= 100; ++i) {
    const double u = dof->lower + span * i / 100;
    const double off = joint_value(joint, u) - at_lower - ratio * (u - dof->lower);
    least = std::min(least, off);
    most = std::max(most, off);
  }
  return {ratio, at_lower - ratio * dof->lower + (least + most) / 2, (most - least) / 2};
}

}  // namespace thenar::internal
