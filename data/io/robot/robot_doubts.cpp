#include "data/io/robot/robot_doubts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "base/words.h"

namespace thenar {
namespace {

constexpr double kLargest = 10;        // shape or offset: larger ones are in another unit [m]
constexpr double kMostTurn = 4 * kPi;  // of a hinge between its limits [rad]
constexpr double kLeastTorque = 100, kLeastForce = 1000;  // of placeholders [N m], [N]

/// Longest side of a mesh, otherwise the largest size of a shape, such as a radius [m].
double across(const ShapeSpec& shape) {
  if (shape.kind != ShapeKind::kMesh) return shape.size.maxCoeff();
  return (shape.mesh.vertices.rowwise().maxCoeff() - shape.mesh.vertices.rowwise().minCoeff())
      .maxCoeff();
}

/// "joint 'a'", "joints 'a', 'b' and 3 more".
std::string these(const std::string& what, const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back("'" + name + "'");
  return what + (names.size() == 1 ? " " : "s ") + some_of(quoted);
}

/// Shapes of implausible size, and joints far from their parents.
void doubt_sizes(const RobotSpec& robot, std::vector<std::string>& doubts) {
  for (const RobotLink& link : robot.links)
    for (const ShapeSpec& shape : link.shapes) {
      const double size = across(shape);
      if (!(size > kLargest)) continue;
      doubts.push_back(
          shape.kind == ShapeKind::kMesh
              ? fmt::format("a mesh of link '{}' is {:.4g} m across: are its numbers millimetres, "
                            "and its scale (0.001) not given?",
                            link.name, size)
              : fmt::format("a {} of link '{}' has a size of {:.4g} m: are its numbers "
                            "millimetres? Lengths are read as metres",
                            name_of(shape.kind), link.name, size));
    }
  for (const RobotJoint& joint : robot.joints)
    if (joint.X_PJ.p.norm() > kLargest)
      doubts.push_back(fmt::format(
          "joint '{}' lies {:.4g} m from its parent's frame: are its numbers millimetres? Lengths "
          "are read as metres",
          joint.name, joint.X_PJ.p.norm()));
}

void doubt_joints(const RobotSpec& robot, std::vector<std::string>& doubts) {
  std::vector<std::string> stuck;
  for (const RobotJoint& joint : robot.joints) {
    const double range = joint.upper - joint.lower;
    if (joint.kind == RobotJointKind::kRevolute && range > kMostTurn && std::isfinite(range))
      doubts.push_back(
          fmt::format("hinge '{}' turns by {:.4g} degrees: are its limits degrees? Angles are read "
                      "as radians",
                      joint.name, degrees(range)));
    if (!joint.dof.empty() && range == 0) stuck.push_back(joint.name);
  }
  if (!stuck.empty())
    doubts.push_back(
        fmt::format("{} cannot move: the upper limit is the lower one", these("joint", stuck)));
}

}  // namespace

std::vector<std::string> robot_doubts(const RobotSpec& robot) {
  std::vector<std::string> doubts;
  doubt_sizes(robot, doubts);
  doubt_joints(robot, doubts);
  return doubts;
}

std::vector<std::string> mass_doubts(const RobotSpec& robot) {
  std::vector<std::string> massless;
  bool any = false;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const RobotLink& link = robot.links[i];
    any = any || link.mass > 0;
    if (i > 0 && !(link.mass > 0) && !link.shapes.empty()) massless.push_back(link.name);
  }
  if (!any || massless.empty()) return {};
  return {fmt::format("{} {} shapes and no mass", these("link", massless),
                      massless.size() == 1 ? "has" : "have")};
}

void doubt_efforts(RobotSpec& robot) {
  if (robot.dofs.empty()) return;
  const auto all = [&](const auto& is) {
    return std::all_of(robot.dofs.begin(), robot.dofs.end(), is);
  };
  if (all([](const RobotDof& dof) { return dof.max_effort == 0; })) {
    const bool said = std::any_of(
        robot.warnings.begin(), robot.warnings.end(),
        [](const std::string& w) { return w.find("unknown effort") != std::string::npos; });
    if (!said) robot.warnings.emplace_back("no joint has an effort: all are of unknown effort");
    return;
  }
  // Too large for any hand, and all the same or round.
  const bool large = all([&](const RobotDof& dof) {
    return dof.max_effort >= (slides(robot, dof) ? kLeastForce : kLeastTorque);
  });
  const double first = robot.dofs.front().max_effort;
  const bool equal = all([&](const RobotDof& dof) { return dof.max_effort == first; });
  const bool round = all([](const RobotDof& dof) { return std::fmod(dof.max_effort, 10) == 0; });
  if (!large || !(equal || round)) return;
  double least = first;
  for (RobotDof& dof : robot.dofs) {
    dof.nominal_effort = true;
    least = std::min(least, dof.max_effort);
  }
  robot.warnings.push_back(
      fmt::format("efforts of {:.4g} {}in all joints are taken for placeholders: they are unknown",
                  least, equal ? "" : "and more "));
}

}  // namespace thenar
