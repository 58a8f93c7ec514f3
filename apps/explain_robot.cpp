// What a robot is made of: links, joints, and the motors that drive them.

#include <fmt/format.h>

#include "apps/explanation.h"
#include "apps/file_summary.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "report/table.h"

namespace thenar {
namespace {

/// Degrees of what turns, millimetres of what slides.
std::string in_units(double value, bool slides) {
  return slides ? shown(value / kMm, 1) + " mm" : shown(value / kDegree, 1) + " deg";
}

std::string word(RobotDofKind kind) {
  constexpr const char* kWords[] = {"rigid", "breakaway", "compliant"};
  return kWords[static_cast<std::size_t>(kind)];
}

Section explain_motors(const RobotSpec& robot) {
  Section section{"motors", "Motors", {}, {}};
  section.table.header = {"name", "kind", "from", "to", "closes_at", "effort", "drives"};
  for (const RobotDof& dof : robot.dofs) {
    std::vector<std::string> joints;
    for (const RobotJoint& joint : robot.joints)
      if (joint.dof == dof.name)
        joints.push_back(joint.ratio == 1 ? joint.name
                                          : joint.name + " x " + shown(joint.ratio, 3));
    const bool sliding = slides(robot, dof);
    const std::string effort = shown(dof.max_effort, 2) + (sliding ? " N" : " Nm") +
                               (dof.nominal_effort ? " (nominal)" : "");
    section.table.rows.push_back({dof.name, word(dof.kind), in_units(dof.lower, sliding),
                                  in_units(dof.upper, sliding), shown(dof.speed, 2),
                                  dof.max_effort > 0 ? effort : "-", listed(joints)});
  }
  return section;
}

Section explain_joints(const RobotSpec& robot) {
  Section section{"joints", "Joints", {}, {}};
  section.table.header = {"name", "kind", "parent", "child", "from", "to", "motor"};
  for (const RobotJoint& joint : robot.joints) {
    const bool sliding = joint.kind == RobotJointKind::kPrismatic;
    const bool fixed = joint.kind == RobotJointKind::kFixed;
    section.table.rows.push_back({joint.name, name_of(joint.kind), joint.parent, joint.child,
                                  fixed ? "-" : in_units(joint.lower, sliding),
                                  fixed ? "-" : in_units(joint.upper, sliding),
                                  or_dash(joint.dof)});
  }
  return section;
}

Section explain_links(const RobotSpec& robot) {
  Section section{"links", "Links", {}, {}};
  section.table.header = {"name", "digit", "mass_g", "material", "shapes"};
  for (const RobotLink& link : robot.links)
    section.table.rows.push_back({link.name, or_dash(link.digit),
                                  link.mass > 0 ? shown(link.mass * 1e3, 1) : "-",
                                  or_dash(link.material), std::to_string(link.shapes.size())});
  return section;
}

}  // namespace

Explanation explain(const RobotSpec& robot) {
  Section header{
      "robot",
      fmt::format("robot '{}': {}, {}, {}", robot.name, counted(robot.links.size(), "link"),
                  counted(robot.joints.size(), "joint"), counted(robot.dofs.size(), "motor")),
      {},
      {}};
  header.lines = {or_dash(robot.description), "source " + or_dash(robot.source)};
  return {header, explain_motors(robot), explain_joints(robot), explain_links(robot)};
}

}  // namespace thenar
